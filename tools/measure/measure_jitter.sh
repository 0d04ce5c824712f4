#!/bin/sh
# Measures the errors that the jitter makes and leaves the tables of docs/results/jitter.md for
# tools/measure/update_tables.sh. usage: tools/measure/measure_jitter.sh [--data DIR] OUT
#   --data DIR   recorded sequences, too short for whole cycles: the lattice alone is measured
#                (default: $WARPLUT_DATA)
#   OUT          sequences; the tables go to OUT/tables
# The program is build/release/tools/warplut, or $WARPLUT. Renderings that are there are not made
# again.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
lut=luts/baked/warplut_iir_x2.json
modes=sr,sr-residual,sr-sample,taau,sgsr2,fsr2

# judge TABLE OPTION...: the table of warplut judge, without baselines and times.
judge() {
  table=$out/tables/$1.md
  shift
  "$warplut" judge --markdown --jitter --modes "$modes" --lut "$lut" "$@" > "$table.judged"
  sed -E '/^[|]/s/[^|]*[|]$//' "$table.judged" \
    | awk -F ' *[|] *' -v modes=",$modes," '
        /^[|]/ && NR > 1 && $2 !~ /^-/ && index(modes, "," $2 ",") == 0 && seen { if ($3 ~ /^[0-9]/) next }
        { seen = 1; print }' > "$table.part"
  rm "$table.judged"
  mv "$table.part" "$table"
}

for scene in penumbra rims still courtyard; do
  render_missing "$scene" "$out/scenes-jitter" --width 480 --height 270 --frames 97
done
judge jitter-scenes --sequence "$out"/scenes-jitter/penumbra "$out"/scenes-jitter/rims \
  "$out"/scenes-jitter/still "$out"/scenes-jitter/courtyard
if [ -n "$data" ]; then judge jitter-recordings --sequence "$data"/*/sequence.json; fi
