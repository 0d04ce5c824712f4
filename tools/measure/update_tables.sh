#!/bin/sh
# Rewrites the tables of README.md and docs/*.md from the output of the commands that measure them.
# usage: tools/measure/update_tables.sh FOLDER
# FOLDER holds one file NAME.md for each table to rewrite (quickstart.sh leaves its tables in OUT/tables). What stands
# between '<!-- table: NAME -->' and '<!-- end -->' is replaced; tables without a file stay as they are.
set -eu

if [ $# -ne 1 ] || [ ! -d "$1" ]; then
  echo "usage: tools/measure/update_tables.sh FOLDER      FOLDER holds NAME.md for each table" >&2
  exit 1
fi
tables=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."

for page in README.md docs/*.md; do
  updated=$page.updated
  awk -v folder="$tables" '
    /^<!-- table: [a-z0-9-]+ -->$/ {
      print
      file = folder "/" $3 ".md"
      count = 0
      while ((getline line < file) > 0) { print line; count++ }
      close(file)
      replaced = count > 0
      inside = 1
      next
    }
    /^<!-- end -->$/ { inside = 0; replaced = 0 }
    !(inside && replaced) { print }
  ' "$page" > "$updated"
  if cmp -s "$page" "$updated"; then
    rm "$updated"
  else
    mv "$updated" "$page"
    echo "updated $page"
  fi
done
