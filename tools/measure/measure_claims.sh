#!/bin/sh
# Measures what papers claim about the methods that run here, and leaves the tables of
# docs/results/claims.md for tools/measure/update_tables.sh.
# usage: tools/measure/measure_claims.sh [--data DIR] OUT
#   --data DIR   recorded sequences (default: $WARPLUT_DATA; without it only built-in scenes)
#   OUT          sequences and scores; the tables go to OUT/tables
# The program is build/release/tools/warplut, or $WARPLUT. Renderings and scores that are there are
# not made again.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
lut=luts/baked/warplut_iir_x2.json
generated=i,e,i-paper,e-paper,i-paper-uniform,e-paper-uniform,3dwarp,3dwarp-e,3dwarp-e-sheet,bidir,flow
generated=$generated,mesh-e,mesh,mesh-between
resolved=sr,sr-paper,taau,sgsr2,fsr2
joint=isr-paper,esr-paper
projected=e,3dwarp-e,3dwarp-e-sheet,mesh-e,mesh-between,mesh

# judge SET NAME MODES OPTION...: lines 'SET NAME/METHOD PSNR SSIM MS' of the means over the set.
judge() {
  set_name=$1 name=$2 modes=$3
  shift 3
  if [ ! -f "$out/$set_name-$name.txt" ]; then
    case "$set_name" in
      recorded) set -- "$@" --sequence "$data"/*/sequence.json ;;
      scenes) set -- "$@" --sequence "$out"/scenes/* ;;
    esac
    "$warplut" judge --modes "$modes" --markdown "$@" > "$out/$set_name-$name.md"
    awk -F ' *[|] *' -v set_name="$set_name" -v name="$name" '
      /^[|] mean / { mean = 1; next }
      mean && NF > 5 && $3 ~ /[0-9]/ { print set_name, name "/" $2, $3, $4, $(NF - 1) }
    ' "$out/$set_name-$name.md" > "$out/$set_name-$name.part"
    mv "$out/$set_name-$name.part" "$out/$set_name-$name.txt"
  fi
  cat "$out/$set_name-$name.txt"
}

# measure SET
measure() {
  judge "$1" generated "$generated" --lut "$lut"
  judge "$1" resolved "$resolved" --lut "$lut"
  judge "$1" joint "$joint" --lut "$lut"
  judge "$1" lut sr-paper --lut luts/baked/warplut_sr_x2.json
  judge "$1" bicubic sr-paper --filter catmull-rom
  judge "$1" bilinear sr-paper --filter bilinear
}

for scene in gallery harbour colonnade; do
  render_missing "$scene" "$out/scenes" --width 480 --height 270 --frames 10
done
{
  measure scenes
  if [ -n "$data" ]; then measure recorded; fi
} > "$out/scores.txt"
awk -f tools/measure/claims_table.awk "$out/scores.txt" > "$out/tables/claims.md"
awk -v generated=1 -f tools/measure/claims_scores.awk "$out/scores.txt" > "$out/tables/claims-generated.md"
awk -v generated=0 -f tools/measure/claims_scores.awk "$out/scores.txt" > "$out/tables/claims-resolved.md"
if [ -n "$data" ]; then
  "$warplut" judge --modes "$projected" --filter catmull-rom --markdown \
    --sequence "$data"/*/sequence.json > "$out/projected.md"
  sed -n '/^|/p; /^$/p' "$out/projected.md" | cat -s > "$out/tables/claims-mesh.md"
fi
