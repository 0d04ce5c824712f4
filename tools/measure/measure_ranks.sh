#!/bin/sh
# Compares one rank with two threads and two ranks with one thread each, and leaves the table of
# docs/results/cluster.md for tools/measure/update_tables.sh. Fails where their results differ.
# usage: tools/measure/measure_ranks.sh OUT
# The program is build/release/tools/warplut, or $WARPLUT. Wants a quiet machine of two cores.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
table=$out/tables/ranks.md

# A container's user may be root.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

seconds() {
  start=$(date +%s.%N)
  "$@" > "$out/ranks.log" 2>&1 || { cat "$out/ranks.log" >&2; exit 1; }
  end=$(date +%s.%N)
  awk "BEGIN { printf \"%.2f\\n\", $end - $start }"
}

# row NAME COMMAND...: the least times, taken alternately, of the command with --out.
row() {
  name=$1
  shift
  : > "$out/alone.times"
  : > "$out/shared.times"
  for _ in 1 2 3; do
    seconds "$warplut" "$@" --threads 2 --out "$out/alone.json" >> "$out/alone.times"
    seconds mpirun -n 2 --bind-to core "$warplut" "$@" --threads 1 --out "$out/shared.json" \
      >> "$out/shared.times"
  done
  for side in alone shared; do
    sed 's/"seconds": *[-+.0-9e]*//g' "$out/$side.json" > "$out/$side.text"
  done
  cmp "$out/alone.text" "$out/shared.text"
  alone=$(sort -n "$out/alone.times" | head -n 1)
  shared=$(sort -n "$out/shared.times" | head -n 1)
  share=$(awk "BEGIN { printf \"%.2f\", $alone / $shared }")
  echo "| $name | $alone | $shared | $share |" >> "$table.part"
}

for scene in still courtyard street meadow machinery plaza; do
  render_missing "$scene" "$out/scenes" --width 480 --height 270 --frames 8 --samples 16
done
echo "| work | 1 rank, 2 threads, s | 2 ranks, 1 thread each, s | share of the speed |" \
  > "$table.part"
echo "|---|---|---|---|" >> "$table.part"
row "train, 2 stages of 20 iterations" train --data "$out/scenes" --name ranks --stages 2 \
  --iterations 20
row "calibrate sr, 4 clips" calibrate --sequence "$out/scenes/courtyard" "$out/scenes/street" \
  "$out/scenes/plaza" "$out/scenes/meadow" --modes sr --filter catmull-rom --starts 0 \
  --fit blend_a,blend_b
mv "$table.part" "$table"
cat "$table"
