#!/bin/sh
# Kills commands (SIGKILL) at random moments, goes on with the same commands, and compares what they
# leave with uninterrupted runs, bit for bit. Prints a table; ends with 1 if there is a fault.
# usage: tools/measure/kills.sh KILLS [SEED [COMMAND...]]
#   KILLS   number of kills over all commands
#   SEED    of the moments, a whole number (default: 1)
#   COMMAND render, train, calibrate, run or report (default: all of them)
# The program is build/release/tools/warplut, or $WARPLUT. A fault is a file under its final name
# that is not the whole file, a resumed command that fails, an output that differs from that of the
# uninterrupted run, or a file that stays beside it. Commands are small and take a second or so each.
set -eu

case "${1:-}${2:-}" in
  '' | *[!0-9]*)
    echo "usage: tools/measure/kills.sh KILLS [SEED [COMMAND...]], with whole numbers" >&2
    exit 1
    ;;
esac
kills=$1
seed=${2:-1}
shift
if [ $# -gt 0 ]; then shift; fi
if [ $# -eq 0 ]; then set -- render train calibrate run report; fi
# shellcheck source=tools/measure/small_inputs.sh
. "$(dirname "$0")/small_inputs.sh"

# command_of COMMAND: its command line, for the folder `out` of the working folder.
command_of() {
  case "$1" in
    render)
      echo dataset render machinery --out out --width 96 --height 64 --frames 12 --samples 8
      ;;
    train)
      echo train --data ../images/courtyard --out out/fit.json --name fit --horizons 2 --crops 8 --stages 2 \
        --iterations 3
      ;;
    calibrate)
      echo calibrate --sequence ../input/street --modes sr --lut "$lut" --out out/params.json --fit blend_a blend_b \
        --starts 2
      ;;
    run) echo run --sequence ../input/street --mode sr,isr --lut "$lut" --out out ;;
    report) echo report --quick --sections calibration --sequence ../input/street --out out ;;
  esac
}

# What may differ: seconds in the log of a training and on the page of a report.
comparable() {
  case "$1" in
    train) sed -E 's/"seconds": [-+.e0-9]+/"seconds": 0/' ;;
    report) sed -E 's/[0-9.]+ (seconds|s|ms|minutes|hours)\b//g; s/"(seconds|milliseconds|date|time)": [^,]*//g' ;;
    *) cat ;;
  esac
}

# same COMMAND FILE OTHER: whether both hold the same but for times.
same() {
  case "$2" in
    *.json | *.html | *.md | *.csv)
      comparable "$1" < "$2" > "$work/one"
      comparable "$1" < "$3" > "$work/other"
      cmp -s "$work/one" "$work/other"
      ;;
    *) cmp -s "$2" "$3" ;;
  esac
}

# list FOLDER: its files.
list() { (cd "$1" && find . -type f | sort); }

# tell FAULT...: counts a fault of $name.
tell() {
  echo "kills.sh: $name: $*" >&2
  faults=$((faults + 1))
}

# Files under their final names are whole, at any moment.
check_whole() {
  for file in $(list "$name/out"); do
    case "$file" in
      */.* | *.checkpoint | *.partial) continue ;;
    esac
    if [ ! -f "$name.whole/out/$file" ]; then
      tell "$file is not there without a kill"
    elif ! same "$name" "$name/out/$file" "$name.whole/out/$file"; then
      tell "$file is not the whole file after a kill"
    fi
  done
}

# resumed: the options that go on with what is there.
resumed() {
  case "$name" in
    train) if [ -f "$name/out/fit.json.checkpoint" ]; then echo --resume; fi ;;
    calibrate) if [ -f "$name/out/params.json.checkpoint" ]; then echo --resume; fi ;;
  esac
}

echo "| command | seconds | kills | after the end | rounds | faults |"
echo "|---|---|---|---|---|---|"
total=0
number=0
left_commands=$#
for name in "$@"; do
  mkdir -p "$name/out" "$name.whole/out"
  begun=$(date +%s%N)
  # shellcheck disable=SC2046 # options without spaces
  (cd "$name.whole" && "$warplut" $(command_of "$name") > log 2>&1)
  milliseconds=$((($(date +%s%N) - begun) / 1000000))
  done_here=0
  late=0
  rounds=0
  faults=0
  wanted=$((kills / left_commands))
  kills=$((kills - wanted))
  left_commands=$((left_commands - 1))
  while [ "$done_here" -lt "$wanted" ]; do
    rm -rf "$name/out"
    mkdir -p "$name/out"
    rounds=$((rounds + 1))
    in_round=0
    while [ "$in_round" -lt 4 ] && [ "$done_here" -lt "$wanted" ]; do
      number=$((number + 1))
      wait_for=$(awk -v seed="$seed" -v number="$number" -v most="$milliseconds" \
        'BEGIN { srand(seed * 100003 + number); rand(); printf "%.3f", rand() * most / 1000 }')
      # shellcheck disable=SC2046
      (cd "$name" && exec "$warplut" $(command_of "$name") $(resumed) > log 2>&1) &
      process=$!
      sleep "$wait_for"
      kill -9 "$process" 2> /dev/null || true
      status=0
      wait "$process" 2> /dev/null || status=$?
      if [ "$status" -eq 137 ]; then
        done_here=$((done_here + 1))
        in_round=$((in_round + 1))
        check_whole
      else
        late=$((late + 1))
        if [ "$status" -ne 0 ]; then tell "exit code $status: $(tail -n 1 "$name/log")"; fi
        break
      fi
    done
    # shellcheck disable=SC2046
    if ! (cd "$name" && "$warplut" $(command_of "$name") $(resumed) > log 2>&1); then
      tell "the command does not go on: $(tail -n 1 "$name/log")"
      continue
    fi
    check_whole
    if [ "$(list "$name/out")" != "$(list "$name.whole/out")" ]; then
      tell "other files than without kills: $(list "$name/out" | grep -vxF "$(list "$name.whole/out")" | tr '\n' ' ')"
    fi
  done
  total=$((total + faults))
  echo "| $name | $((milliseconds / 1000)).$((milliseconds % 1000 / 100)) | $done_here | $late | $rounds | $faults |"
done
if [ "$total" -gt 0 ]; then exit 1; fi
