#!/bin/sh
# Puts the programs of runtime/example into the pages that show them.
# usage: tools/update_examples.sh [--check]
#   --check   changes nothing; names the pages that differ from the files, and ends with 1 if any
#             does
# The text between '<!-- file: PATH -->' and '<!-- end -->' becomes a code block with the text of
# PATH.
set -eu

case "${1:-}" in
  '' | --check) mode=${1:-} ;;
  *)
    echo "update_examples.sh: '$1' is not an option; expected --check or nothing." >&2
    exit 1
    ;;
esac
cd "$(dirname "$0")/.."

code=0
updated=$(mktemp)
trap 'rm -f "$updated"' EXIT
for page in README.md docs/*.md; do
  awk -v page="$page" '
    /^<!-- file: [^ ]+ -->$/ {
      file = $3
      print
      print "```cpp"
      count = 0
      while ((getline line < file) > 0) { print line; count++ }
      close(file)
      if (count == 0) {
        print "update_examples.sh: " page " shows " file ", which is not there." > "/dev/stderr"
        exit 1
      }
      print "```"
      inside = 1
      next
    }
    /^<!-- end -->$/ { inside = 0 }
    !inside { print }
  ' "$page" > "$updated"
  if cmp -s "$page" "$updated"; then continue; fi
  if [ -n "$mode" ]; then
    echo "$page differs from the files that it shows; tools/update_examples.sh writes them." >&2
    code=1
  else
    cp "$updated" "$page"
    echo "updated $page"
  fi
done
exit "$code"
