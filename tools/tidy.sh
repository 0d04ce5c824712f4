#!/bin/sh
# Runs clang-tidy (.clang-tidy) on the sources that changed. usage: tools/tidy.sh [BASE [COUNT]]
#   BASE    commit that they are compared with (default: the one before the last)
#   COUNT   most sources that are checked, those that changed last first (default: all)
# Prints what it finds in the changed files, and ends with 1 if there is anything. Ends with 0 and a
# sentence where there is no clang-tidy or no such commit.
set -eu
cd "$(dirname "$0")/.."
base=${1:-HEAD~1}
count=${2:-1000000}

if ! command -v clang-tidy > /dev/null; then
  echo "tidy.sh: there is no clang-tidy; nothing is checked."
  exit 0
fi
if ! git rev-parse --verify --quiet "$base^{commit}" > /dev/null; then
  echo "tidy.sh: there is no commit '$base'; nothing is checked."
  exit 0
fi

# Not a unity build: each source has its own command.
mkdir -p build
cmake --preset dev > build/dev-configure.log 2>&1 || { cat build/dev-configure.log; exit 1; }
changed=$(git diff --name-only --diff-filter=d "$base" -- datasets luts runtime tools train tests)
sources=$(for file in $changed; do
  case $file in
    luts/baked/* | tests/package/*) ;;
    *.cpp) if grep -q "/$file\"" build/dev/compile_commands.json; then echo "$file"; fi ;;
  esac
done | xargs -r ls -t | head -n "$count")
if [ -z "$sources" ]; then
  echo "tidy.sh: no source changed since $base."
  exit 0
fi
echo "$sources" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/dev --quiet > build/tidy.log 2> /dev/null || true
faults=0
for file in $changed; do
  # A header is found by its link in build/dev/include.
  if grep -F "$file:" build/tidy.log | grep -E ': (warning|error):' | sort -u; then faults=1; fi
done
if [ "$faults" -eq 0 ]; then echo "tidy.sh: $(echo "$sources" | wc -l) sources, nothing found."; fi
exit "$faults"
