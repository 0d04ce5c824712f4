#!/bin/sh
# Builds the fuzzers and runs each for some seconds. Prints executions, coverage and faults as a
# table, and ends with 1 if there is a fault. usage: tools/measure/fuzz.sh SECONDS [TARGET...]
#   SECONDS   of each target
#   TARGET    names of folders of tests/fuzz/corpus (default: all of them); command_line compiles the
#             whole program, which takes long
# A fault is a crash, a leak, undefined behaviour, 30 s on one input, 1 GiB in one piece or 2 GiB of
# memory, or a promise that does not hold.
# Inputs that were found stay in build/fuzz/found, those that are faults in build/fuzz/faults. A
# fault that is mended goes into the corpus of its target, as a test. Needs clang++ with libFuzzer.
set -eu
cd "$(dirname "$0")/../.."

case "${1:-}" in
  '' | *[!0-9]*)
    echo "fuzz.sh: expected seconds of each target, a whole number, and perhaps names of targets." >&2
    exit 1
    ;;
esac
seconds=$1
shift
if ! command -v clang++ > /dev/null; then
  echo "fuzz.sh: clang++ is not installed; it has libFuzzer." >&2
  exit 2
fi
if [ $# -eq 0 ]; then
  for folder in tests/fuzz/corpus/*/; do set -- "$@" "$(basename "$folder")"; done
fi
for target in "$@"; do
  if [ ! -d "tests/fuzz/corpus/$target" ]; then
    echo "fuzz.sh: '$target' is no target; expected a folder of tests/fuzz/corpus." >&2
    exit 1
  fi
done

mkdir -p build/fuzz
programs=
for target in "$@"; do programs="$programs fuzz_$target"; done
# shellcheck disable=SC2086 # a list of targets
if ! { cmake --preset fuzz && cmake --build --preset fuzz --target $programs; } > build/fuzz/build.log 2>&1; then
  tail -n 20 build/fuzz/build.log
  exit 2
fi

# sum_of NAME LOG: the sum of the lines "stat::NAME: VALUE", one of each start.
sum_of() { awk -v name="stat::$1:" '$1 == name { sum += $2 } END { print sum + 0 }' "$2"; }

export OPENIMAGEIO_OPTIONS=threads=1,exr_threads=1
total=0
echo "| target | seconds | executions | per second | edges covered | corpus | faults |"
echo "|---|---|---|---|---|---|---|"
for target in "$@"; do
  found=build/fuzz/found/$target
  faults=build/fuzz/faults/$target
  log=build/fuzz/$target.log
  mkdir -p "$found" "$faults"
  : > "$log"
  # libFuzzer ends at a fault; it begins again until the time is up.
  begun=$(date +%s)
  left=$seconds
  while [ "$left" -gt 0 ]; do
    dictionary=tests/fuzz/json.dict
    longest=65536
    case "$target" in
      table_exr | packed_png | motion | image)
        dictionary=tests/fuzz/image.dict
        longest=32768
        ;;
      command_line)
        dictionary=tests/fuzz/command_line.dict
        longest=1024
        ;;
    esac
    "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="$left" -timeout=30 -report_slow_units=30 -rss_limit_mb=2048 \
      -malloc_limit_mb=1024 -max_len="$longest" -dict="$dictionary" -print_final_stats=1 -seed=1 \
      -artifact_prefix="$faults/" "$found" "tests/fuzz/corpus/$target" >> "$log" 2>&1 || true
    left=$((seconds - $(date +%s) + begun))
    if [ "$(find "$faults" -type f | wc -l)" -ge 10 ]; then break; fi
  done
  executions=$(sum_of number_of_executed_units "$log")
  spent=$(($(date +%s) - begun))
  if [ "$spent" -eq 0 ]; then spent=1; fi
  covered=$(awk '{ for (i = 1; i < NF; ++i) if ($i == "cov:" && $(i + 1) > most) most = $(i + 1) }
    END { print most + 0 }' "$log")
  corpus=$(find "$found" "tests/fuzz/corpus/$target" -type f | wc -l)
  count=$(find "$faults" -type f | wc -l)
  total=$((total + count))
  echo "| $target | $spent | $executions | $((executions / spent)) | $covered | $corpus | $count |"
done
if [ "$total" -gt 0 ]; then
  echo "fuzz.sh: $total inputs are faults; build/fuzz/faults has them." >&2
  exit 1
fi
