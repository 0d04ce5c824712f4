#!/bin/sh
# Runs commands on a full disk, on a read-only one, with files that shrink while they are read, and
# twice at once into one folder. Prints a table; ends with 1 if there is a fault.
# usage: tools/measure/hazards.sh [TIMES]
#   TIMES   how often files shrink and commands meet, each (default: 10)
# The program is build/release/tools/warplut, or $WARPLUT. A fault is an exit code other than the
# expected ones, a signal, more than one sentence, a file under its final name that is not whole, or
# a file that stays beside it. Small disks need `unshare -m` and `mount`; without them these rows say
# so.
set -eu

case "${1:-}" in
  *[!0-9]*)
    echo "usage: tools/measure/hazards.sh [TIMES], a whole number" >&2
    exit 1
    ;;
esac
times=${1:-10}
# shellcheck source=tools/measure/small_inputs.sh
. "$(dirname "$0")/small_inputs.sh"
fit=$root/luts/fits/warplut_sr_x2.json
"$warplut" bake "$fit" --out whole/bake > /dev/null
"$warplut" run --sequence input/street --mode sr --lut "$lut" --out whole/run > /dev/null
cp -r input/street whole/render

# command_of COMMAND FOLDER: its command line, with outputs in FOLDER.
command_of() {
  case "$1" in
    render) echo dataset render street --out "$2" --width 64 --height 48 --frames 8 --samples 4 ;;
    bake) echo bake "$fit" --out "$2/bake" ;;
    run) echo run --sequence input/street --mode sr --lut "$lut" --out "$2/run" ;;
    train)
      echo train --data images/courtyard --out "$2/fit.json" --name fit --horizons 2 --crops 8 --stages 1 --iterations 2
      ;;
    calibrate)
      echo calibrate --sequence input/street --modes sr --lut "$lut" --out "$2/params.json" --fit blend_a --starts 1
      ;;
  esac
}

total=0
faults=0
tell() {
  echo "hazards.sh: $*" >&2
  faults=$((faults + 1))
}
row() {
  echo "| $1 | $2 | $faults |"
  total=$((total + faults))
  faults=0
}

# refused NAME STATUS LOG: whether a command ended with 2 and one sentence.
refused() {
  if [ "$2" -ne 2 ]; then tell "$1 ended with $2: $(tail -n 1 "$3")"; fi
  if [ "$(grep -c '^warplut: .*[.]$' "$3")" -ne 1 ]; then tell "$1 does not say one sentence: $(cat "$3")"; fi
}

# nothing_beside NAME FOLDER
nothing_beside() {
  if find "$2" -name '.*.tmp*' | grep -q .; then tell "$1 left $(find "$2" -name '.*.tmp*' | tr '\n' ' ')"; fi
}

# whole_files NAME FOLDER: files that the uninterrupted command has too are the same.
whole_files() {
  case "$1" in
    render) there=$2/street there_whole=whole/render ;;
    bake | run) there=$2/$1 there_whole=whole/$1 ;;
    *) return 0 ;;
  esac
  if [ ! -d "$there" ]; then return 0; fi
  for file in $(cd "$there" && find . -type f ! -name '*.partial'); do
    if ! cmp -s "$there/$file" "$there_whole/$file"; then tell "$1 left $file, which is not whole"; fi
  done
}

# on_small_disk SIZE OPTION: every command on a disk of that size in bytes, mounted with OPTION.
on_small_disk() {
  for name in render bake run train calibrate; do
    mkdir -p disk
    status=0
    # shellcheck disable=SC2016,SC2046 # for the shell inside; options without spaces
    unshare -m sh -c 'mount -t tmpfs -o size="$1" tmpfs disk && mount -o remount,"$2" disk && shift 2 &&
      { "$@" > out.log 2> err.log; status=$?; cp -r disk copy; exit "$status"; }' \
      sh "$1" "$2" "$warplut" $(command_of "$name" disk) || status=$?
    refused "$name on $3" "$status" err.log
    nothing_beside "$name" copy
    whole_files "$name" copy
    rm -rf copy
  done
}

echo "| hazard | commands | faults |"
echo "|---|---|---|"
if unshare -m sh -c "mkdir -p $work/disk && mount -t tmpfs tmpfs $work/disk" 2> /dev/null; then
  on_small_disk 16k rw "a full disk"
  row "a full disk" 5
  on_small_disk 16k ro "a read-only disk"
  row "a read-only disk" 5
else
  echo "| a full disk, a read-only disk | no mount permitted | |"
fi

# A file is cut and written again, over and over, while a command reads it.
count=0
while [ "$count" -lt "$times" ]; do
  count=$((count + 1))
  cp -r input/street shrinking
  cp "$fit" shrinking.json
  (
    while [ ! -e stop ]; do
      for file in lr/color/0003.png lr/depth/0003.exr hr/color/0005.png sequence.json; do
        truncate -s 40 "shrinking/$file"
        cp "input/street/$file" "shrinking/$file"
      done
      truncate -s 5000 shrinking.json
      cp "$fit" shrinking.json
    done
  ) &
  shrinker=$!
  for arguments in "dataset inspect shrinking" "run --sequence shrinking --mode isr --lut $lut --out shrunk" \
    "judge --sequence shrinking --modes sr --lut $lut" "bake shrinking.json --out shrunk"; do
    status=0
    # shellcheck disable=SC2086 # options without spaces
    "$warplut" $arguments > out.log 2> err.log || status=$?
    if [ "$status" -ne 0 ] && [ "$status" -ne 2 ]; then tell "'$arguments' ended with $status: $(tail -n 1 err.log)"; fi
  done
  : > stop
  wait "$shrinker"
  rm -rf stop shrinking shrunk shrinking.json
done
row "files that shrink while they are read" $((4 * times))

# The same command twice at once.
count=0
while [ "$count" -lt "$times" ]; do
  count=$((count + 1))
  for name in render bake run train; do
    mkdir both
    one=0
    other=0
    # shellcheck disable=SC2046
    "$warplut" $(command_of "$name" both) > one.log 2>&1 &
    process=$!
    # shellcheck disable=SC2046
    "$warplut" $(command_of "$name" both) > other.log 2>&1 || other=$?
    wait "$process" || one=$?
    for status in "$one" "$other"; do
      if [ "$status" -ne 0 ] && [ "$status" -ne 2 ]; then tell "two of $name: one ended with $status"; fi
    done
    if [ "$one" -ne 0 ] && [ "$other" -ne 0 ]; then tell "two of $name: both failed: $(tail -n 1 one.log)"; fi
    nothing_beside "two of $name" both
    whole_files "$name" both
    rm -rf both
  done
done
row "two runs into one folder" $((8 * times))
if [ "$total" -gt 0 ]; then exit 1; fi
