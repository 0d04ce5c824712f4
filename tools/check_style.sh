#!/bin/sh
# Checks sources, scripts and pages by docs/STYLE.md. Each fault is one line, 'FILE:LINE: what is
# wrong'. usage: tools/check_style.sh [FOLDER]
#   FOLDER   the project to check (default: this one)
# Ends with 1 if there is any fault. shellcheck and clang-format 14 are used if they are installed.
# shellcheck disable=SC2016,SC2046  # code of awk; lists of files without spaces in their names
set -eu

case "${1:-}" in
  -*)
    echo "check_style.sh: '$1' is not an option; expected nothing or the folder of a project." >&2
    exit 1
    ;;
esac
cd "${1:-$(dirname "$0")/..}"

faults=$(mktemp)
trap 'rm -f "$faults"' EXIT
folders=
for folder in datasets luts runtime train tools tests cmake docs; do
  if [ -d "$folder" ]; then folders="$folders $folder"; fi
done

# files PATTERN...: the files of the project with such names, but baked headers, which are
# generated.
files() {
  for pattern in "$@"; do
    # shellcheck disable=SC2086 # a list of folders
    find $folders -path luts/baked -prune -o -type f -name "$pattern" -print
    find . -maxdepth 1 -type f -name "$pattern" | sed 's|^\./||'
  done | sort
}

# Lines of at most 100 columns, in scripts and CMake files 120. Pages may have longer tables, links
# and code.
width() {
  awk 'FNR == 1 { fence = marked = 0; most = FILENAME ~ /[.](h|cpp|md)$/ ? 100 : 120 }
    FILENAME ~ /\.md$/ {
      if (/^```/) fence = !fence
      if (/^<!-- (table|file):/) marked = 1
      if (/^<!-- end/) marked = 0
      if (fence || marked || /^ *[|]/ || /^    / || /\]\(/) next
    }
    { columns = $0; gsub(/[\200-\277]/, "", columns) }
    length(columns) > most { print FILENAME ":" FNR ": " length(columns) " columns; " most " at most" }
  ' $(files '*.h' '*.cpp' '*.sh' '*.awk' '*.cmake' CMakeLists.txt '*.md') /dev/null
}

# Sources of at most 400 lines.
length_of_files() {
  awk 'FNR == 401 {
    print FILENAME ":401: a file has 400 lines at most" }' $(files '*.h' '*.cpp') /dev/null
}

# Links of pages lead to files of the project.
links() {
  for page in $(files '*.md'); do
    awk '/^```/ { fence = !fence } fence || /^    / { next }
      { rest = $0; while (match(rest, /\]\([^)]+\)/)) {
          print FNR " " substr(rest, RSTART + 2, RLENGTH - 3)
          rest = substr(rest, RSTART + RLENGTH) } }' "$page" |
      while read -r line target; do
        case "$target" in http*:* | mailto:* | '#'*) continue ;; esac
        if [ ! -e "$(dirname "$page")/${target%%#*}" ]; then
          echo "$page:$line: the link leads to $target, which is not there"
        fi
      done
  done
}

# Files that comments, scripts and pages name are there.
named_files() {
  awk '{
      rest = " " $0
      if (FILENAME ~ /\.(h|cpp)$/ && !sub(/.*\/\/ /, " ", rest)) next
      while (match(rest, /[ (`"](datasets|luts|runtime|train|tools|tests|docs|cmake)\/[A-Za-z0-9_\/.-]+/)) {
        name = substr(rest, RSTART + 1, RLENGTH - 1)
        rest = substr(rest, RSTART + RLENGTH)
        sub(/[.]+$/, "", name)
        if (name ~ /\.(h|cpp|sh|md|awk|cmake)$/ && name !~ /NAME/) print FILENAME ":" FNR " " name
      }
    }' $(files '*.h' '*.cpp' '*.sh' '*.md' '*.awk' '*.cmake' CMakeLists.txt) /dev/null |
    while read -r place name; do
      if [ ! -e "$name" ]; then echo "$place: names $name, which is not there"; fi
    done
}

# Programs on pages are those of their files.
examples() {
  if [ -x tools/update_examples.sh ]; then tools/update_examples.sh --check 2>&1 || true; fi
}

scripts() {
  if ! command -v shellcheck > /dev/null; then
    echo "check_style.sh: shellcheck is not installed; scripts are not checked." >&2
    return
  fi
  scripts=$(files '*.sh')
  # shellcheck disable=SC2086 # a list of files
  if [ -n "$scripts" ]; then shellcheck --format gcc $scripts || true; fi
}

format() {
  if ! clang-format --version 2> /dev/null | grep -q ' version 14\.'; then
    echo "check_style.sh: clang-format 14 is not installed; the format is not checked." >&2
    return
  fi
  clang-format --dry-run $(files '*.h' '*.cpp') /dev/null 2>&1 | grep ': warning: ' || true
}

for check in width length_of_files links named_files examples scripts format; do
  $check >> "$faults"
done
if [ -s "$faults" ]; then
  cat "$faults"
  exit 1
fi
