#!/bin/sh
# Builds the golden hashes with g++ -O1, g++ -O3 and clang++ -O2 and compares them. Prints a table
# of equal and differing hashes for each kind, and ends with 1 if a bit differs that is promised.
# usage: tools/measure/same_bits.sh [--training]
#   --training   hashes of trainings too; these are not promised to be equal for other compilers
# Promised are baked files and modes, each on its instruction set. Hashes stay in build/bits-*.txt;
# those of g++ -O3 are those of tests/golden/hashes.txt.
set -eu
cd "$(dirname "$0")/../.."

case "${1:-}" in
  '' | --training) ;;
  *)
    echo "same_bits.sh: '$1' is not an option; that is --training." >&2
    exit 1
    ;;
esac

# build_and_print NAME COMPILER FLAGS [OPTION]
build_and_print() {
  folder=build/bits-$1
  mkdir -p "$folder"
  if ! { cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS_RELEASE="$3 -DNDEBUG" -DWARPLUT_WARNINGS_AS_ERRORS=ON &&
    cmake --build "$folder" --target golden_print ${4:+golden_print_training}; } > "$folder.log" 2>&1; then
    tail -n 20 "$folder.log"
    exit 2
  fi
  "$folder/tests/golden/golden_print" > "$folder.txt"
  if [ -n "${4:-}" ]; then "$folder/tests/golden/golden_print_training" >> "$folder.txt"; fi
}

build_and_print g++-O3 g++ -O3 "${1:-}"
build_and_print g++-O1 g++ -O1 "${1:-}"
others=g++-O1
if command -v clang++ > /dev/null; then
  build_and_print clang++-O2 clang++ -O2 "${1:-}"
  others="$others clang++-O2"
else
  echo "same_bits.sh: clang++ is not installed; only g++ is compared." >&2
fi

echo "| compiler | hashes | baked: equal, differ | modes: equal, differ | trainings: equal, differ |"
echo "|---|---|---|---|---|"
differ=0
for other in $others; do
  counts=$(awk 'NR == FNR { hash[$1] = $2; next } { kind = $1; sub(/\/.*/, "", kind)
      ++count[kind, hash[$1] == $2] }
    END { printf "%d | %d, %d | %d, %d | %d, %d", FNR, count["bake", 1], count["bake", 0], count["mode", 1],
      count["mode", 0], count["training", 1], count["training", 0] }' build/bits-g++-O3.txt "build/bits-$other.txt")
  echo "| $other | $counts |"
  broken=$(grep -v '^training' "build/bits-$other.txt" | grep -vcxFf build/bits-g++-O3.txt || true)
  differ=$((differ + broken))
done
if [ "$differ" -gt 0 ]; then
  echo "same_bits.sh: $differ promised hashes differ from those of g++ -O3." >&2
  exit 1
fi
