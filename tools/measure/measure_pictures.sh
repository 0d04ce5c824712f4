#!/bin/sh
# Makes the pictures of docs/pictures, on built-in scenes that nothing was fitted on.
# usage: tools/measure/measure_pictures.sh OUT
#   OUT   sequences and all pictures; those that the docs show are copied
# The program is build/release/tools/warplut, or $WARPLUT. Renderings that are there are not made
# again.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"

# After 24 warps by half a pixel: original, Catmull-Rom, LUT.
render_missing gallery "$out/images" --width 360 --height 204 --frames 1 --samples 16 --streams color,reference
"$warplut" eval --images "$out/images/gallery" --lut luts/baked/warplut_iir_x2.json --warps 6 \
  --pictures "$out/pictures" > /dev/null

# Where methods err most and where most was just revealed.
for scene in gallery harbour colonnade; do
  render_missing "$scene" "$out/sequences" --width 640 --height 360 --frames 9 --samples 16
done
"$warplut" judge --sequence "$out"/sequences/* --lut luts/baked/warplut_sr_x2.json --modes sr,i \
  --pictures "$out/pictures" \
  | grep 'png: '

# The table itself.
"$warplut" bake luts/fits/warplut_iir_x2.json --out "$out/baked" > /dev/null

mkdir -p docs/pictures
cp "$out/baked/warplut_iir_x2.png" docs/pictures/warplut_iir_x2.png
cp "$out/pictures/gallery-hr-color-0000-24-half.png" docs/pictures/warps-24-half.png
cp "$out/pictures/gallery-0007-disocclusion.png" docs/pictures/gallery-disocclusion.png
cp "$out/pictures/colonnade-0008-disocclusion.png" docs/pictures/colonnade-disocclusion.png
cp "$out/pictures/harbour-0001-error.png" docs/pictures/harbour-error.png
