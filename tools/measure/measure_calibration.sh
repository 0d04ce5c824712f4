#!/bin/sh
# Calibrates on some clips, judges by others, and leaves the table of docs/results/calibration.md
# for tools/measure/update_tables.sh. usage: tools/measure/measure_calibration.sh [--data DIR] OUT
#   --data DIR   the recorded sequences mobfgsr-sample, stk-lighthouse and stk-scotland
#                (default: $WARPLUT_DATA; without it only built-in scenes are measured)
#   OUT          sequences and parameters; the table goes to OUT/tables
# The program is build/release/tools/warplut, or $WARPLUT. Renderings that are there are not made
# again.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
lut=luts/baked/warplut_x2.json
table=$out/tables/calibration.md

# judge MODES FITTED HELD_OUT OPTION...: one row, of the mean 1 - SSIM over the held-out clips.
judge() {
  modes=$1
  fitted=$2
  held=$3
  shift 3
  params=$out/params/$fitted-$(echo "$modes" | tr , -).json
  "$warplut" calibrate --modes "$modes" --lut "$lut" --max-pixels 30000 --max-frames 8 --starts 0 \
    --hold-out "$held" --out "$params" "$@" > "$params.txt"
  losses=$(awk '$1 == "held" && $2 == "out" { print $3, $4, $5; exit }' "$params.txt")
  # shellcheck disable=SC2086 # three numbers
  set -- $losses
  worse=$(awk "BEGIN { print $1 <= $3 ? \"no\" : \"**yes**\" }")
  echo "| $fitted | $(echo "$held" | sed 's/,/, /g') | $modes | $1 | $2 | $3 | $worse |" >> "$table.part"
}

# rows MODES
rows() {
  judge "$1" street+plaza harbour,gallery,colonnade --sequence "$out"/scenes/*/
  if [ -z "$data" ]; then return; fi
  judge "$1" stk-lighthouse stk-scotland --sequence "$data/stk-lighthouse" "$data/stk-scotland"
  judge "$1" stk-scotland stk-lighthouse --sequence "$data/stk-lighthouse" "$data/stk-scotland"
  judge "$1" mobfgsr-sample stk-lighthouse,stk-scotland --sequence "$data"/*/sequence.json
  judge "$1" stk-lighthouse+stk-scotland mobfgsr-sample --sequence "$data"/*/sequence.json
}

for scene in street plaza harbour gallery colonnade; do
  render_missing "$scene" "$out/scenes" --width 240 --height 136 --scale 2 --frames 6
done
{
  echo '| fitted | held out | modes | calibrated | default | paper | worse than the paper |'
  echo '|---|---|---|---|---|---|---|'
} > "$table.part"
rows sr
rows sr,i,e
rows isr
mv "$table.part" "$table"
