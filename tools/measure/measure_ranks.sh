#!/bin/sh
# Compares one rank with two threads and two ranks with one thread each, fits a model of cost, and
# leaves the tables of docs/results/cluster.md for tools/measure/update_tables.sh. Fails where
# results differ. usage: tools/measure/measure_ranks.sh [--model] OUT
#   --model   only the model: it takes processor time, and so a machine that others use too
# The program is build/release/tools/warplut, or $WARPLUT. Wants a quiet machine of two cores.
set -eu

only=
if [ "${1:-}" = --model ]; then
  only=model
  shift
fi

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

if [ -z "$only" ]; then
  for scene in still courtyard street meadow machinery plaza; do
    render_missing "$scene" "$out/scenes" --width 480 --height 270 --frames 8 --samples 16
  done
  echo "| work | 1 rank, 2 threads, s | 2 ranks, 1 thread each, s | share of the speed |" > "$table.part"
  echo "|---|---|---|---|" >> "$table.part"
  row "train, 2 stages of 20 iterations" train --data "$out/scenes" --name ranks --stages 2 \
    --iterations 20
  row "calibrate sr, 4 clips" calibrate --sequence "$out/scenes/courtyard" "$out/scenes/street" \
    "$out/scenes/plaza" "$out/scenes/meadow" --modes sr --filter catmull-rom --starts 0 \
    --fit blend_a,blend_b
  mv "$table.part" "$table"
  cat "$table"
fi

# busiest RANKS COMMAND...: the busiest rank's processor time without exchanges, the least of two
# runs, with the numbers of the other columns.
busiest() {
  ranks=$1
  shift
  : > "$out/rank.times"
  for _ in 1 2; do
    WARPLUT_RANK_TIMES=1 mpirun --oversubscribe -n "$ranks" "$warplut" "$@" --threads 1 --out "$out/model.json" \
      --json > "$out/model.out" 2> "$out/model.log" || { cat "$out/model.log" >&2; exit 1; }
    # rank 0: 1.5 s of processor time without exchanges, 10 exchanges, 80 bytes, quickest 0.1 s
    awk '/^rank [0-9]+: / { print $3, $10, $12, $15 }' "$out/model.log" | sort -rn | head -n 1 >> "$out/rank.times"
  done
  sort -n "$out/rank.times" | head -n 1
}

# number NAME: the number of that name in what the program printed.
number() { sed -n "s/^ *\"$1\": *\([0-9]*\),*$/\1/p" "$out/model.out" | head -n 1; }

# Clips of the model, small: what it finds is for pixels of any number.
for scene in courtyard street plaza meadow; do
  render_missing "$scene" "$out/small" --width 240 --height 136 --frames 8 --samples 4
done

# calibrations RANKS CLIPS FITTED
calibrations() {
  ranks=$1 clips=$2 fitted=$3
  set --
  for scene in courtyard street plaza meadow; do
    if [ $# -lt "$clips" ]; then set -- "$@" "$out/small/$scene"; fi
  done
  line=$(busiest "$ranks" calibrate --sequence "$@" --modes sr --filter catmull-rom --starts 0 --fit "$fitted")
  share=$(awk "BEGIN { print int(($clips + $ranks - 1) / $ranks) / $clips }")
  echo "calibrate $ranks $share $((8 * clips)) $(number runs) $line" >> "$out/model.runs"
}

# trainings RANKS ITERATIONS
trainings() {
  line=$(busiest "$1" train --data "$out/small" --name ranks --horizons 2,6 --crops 8 --stages 1 \
    --iterations "$2")
  echo "train $1 $(awk "BEGIN { print 1 / $1 }") 0 $(number evaluations) $line" >> "$out/model.runs"
}

: > "$out/model.runs"
calibrations 1 1 blend_a
calibrations 1 2 blend_a
calibrations 1 4 blend_a
calibrations 1 2 blend_a,blend_b
calibrations 1 4 blend_a,blend_b
trainings 1 4
trainings 1 8
trainings 1 16
for ranks in 2 4; do
  calibrations "$ranks" 4 blend_a
  calibrations "$ranks" 4 blend_a,blend_b
  trainings "$ranks" 8
  trainings "$ranks" 16
done
for part in predictions coefficients; do
  awk -v part="$part" -f tools/measure/rank_model.awk "$out/model.runs" > "$out/tables/rank-$part.md"
  cat "$out/tables/rank-$part.md"
done
