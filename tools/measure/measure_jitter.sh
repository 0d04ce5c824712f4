#!/bin/sh
# Measures the errors that the jitter makes and leaves the table of docs/results/jitter.md for
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

# judge NAME OPTION...: the tables of warplut judge with one more sentence, without baselines and
# times.
judge() {
  name=$1
  shift
  "$warplut" judge --markdown --jitter --settled 8 --lut "$lut" "$@" > "$out/$name.judged"
  awk -F ' *[|] *' -v OFS=' | ' '
    !/^[|]/ { if ($0 != "" || !blank) print; blank = $0 == ""; next }
    $2 ~ /^(bilinear|bicubic)$/ { next }
    { blank = 0; print "| " $2, $3, $4, $5, $9, $10 " |" }' "$out/$name.judged"
}

for scene in penumbra rims plaza; do
  render_missing "$scene" "$out/scenes-jitter" --width 320 --height 180 --frames 97 --samples 4
done
set -- "$out"/scenes-jitter/penumbra "$out"/scenes-jitter/rims "$out"/scenes-jitter/plaza
if [ -n "$data" ]; then set -- "$@" "$data"/*/sequence.json; fi
table=$out/tables/jitter.md
{
  judge jitter --modes "$modes" --sequence "$@"
  printf "\nWith \`--coherent-share 0.7\`:\n\n"
  judge jitter-coherent --modes sr --coherent-share 0.7 --sequence "$@"
} > "$table.part"
mv "$table.part" "$table"
