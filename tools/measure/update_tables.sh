#!/bin/sh
# Rewrites the tables of README.md, docs/*.md and docs/results/*.md from the output of the commands
# that measure them. usage: tools/measure/update_tables.sh FOLDER
#   FOLDER   holds one file NAME.md for each table to rewrite (quickstart.sh leaves its tables in
#            OUT/tables)
# The text between '<!-- table: NAME -->' and '<!-- end -->' is replaced. Tables without a file stay
# as they are. The table 'gains' of README.md is made from the tables of docs/results.
set -eu

if [ $# -ne 1 ] || [ ! -d "$1" ]; then
  echo "usage: tools/measure/update_tables.sh FOLDER      FOLDER holds NAME.md for each table" >&2
  exit 1
fi
tables=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."

# rewrite FOLDER PAGE...
rewrite() {
  folder=$1
  shift
  for page in "$@"; do
    updated=$page.updated
    awk -v folder="$folder" '
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
}

rewrite "$tables" README.md docs/*.md docs/results/*.md

summary=$(mktemp -d)
trap 'rm -r "$summary"' EXIT
awk -f tools/measure/gains_table.awk docs/results/resampling.md docs/results/pipeline.md > "$summary/gains.md"
rewrite "$summary" README.md
