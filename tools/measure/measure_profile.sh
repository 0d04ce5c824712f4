#!/bin/sh
# Profiles built-in scenes and leaves the tables of docs/results/profile.md for
# tools/measure/update_tables.sh. usage: tools/measure/measure_profile.sh OUT
#   OUT          sequences and headers; the tables go to OUT/tables
# The program is build/release/tools/warplut, or $WARPLUT. Renderings that are there are not made
# again.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
mkdir -p "$out/headers"

# render SCALE SCENE...
render() {
  scale=$1
  shift
  for scene in "$@"; do
    render_missing "$scene" "$out/scenes-x$scale" --scale "$scale" --width 480 --height 272 --frames 12 --samples 8
  done
}

# profile TABLE SCALE SCENE MODE OPTION...: one row, and all tables in OUT.
profile() {
  table=$out/tables/$1.md
  name=$3-x$2-$4
  sequence=$out/scenes-x$2/$3
  mode=$4
  shift 4
  "$warplut" profile --sequence "$sequence" --mode "$mode" --out "$out/headers/$name.h" --markdown "$@" \
    > "$out/$name.md"
  if [ ! -f "$table.part" ]; then sed -n 1,2p "$out/$name.md" > "$table.part"; fi
  sed -n 3p "$out/$name.md" >> "$table.part"
}

# section TABLE FILE N: the N-th table of a profile.
section() {
  awk -v want="$3" 'BEGIN { RS = ""; ORS = "\n" } NR == want' "$2" > "$out/tables/$1.md"
}

rm -f "$out"/tables/profile*.part
render 2 still courtyard plaza street
render 1 street
for mode in sr i; do
  for scene in still courtyard plaza street; do
    profile profile 2 "$scene" "$mode" --lut luts/baked/warplut_sr_x2.json
  done
done
profile profile 2 still isr --lut luts/baked/warplut_sr_x2.json
for mode in sr isr; do
  profile profile-x1 1 street "$mode" --texels --lut luts/baked/warplut_sr_x1_3.json 2> /dev/null
done
for table in profile profile-x1; do mv "$out/tables/$table.md.part" "$out/tables/$table.md"; done
section profile-alone "$out/street-x2-sr.md" 2
section profile-together "$out/street-x2-sr.md" 3
section profile-tables "$out/street-x2-sr.md" 4
: > "$out/tables/profile-tiles.md.part"
for profile in still-x2-sr still-x2-i courtyard-x2-sr courtyard-x2-i plaza-x2-sr plaza-x2-i street-x2-sr street-x2-i; do
  awk 'BEGIN { RS = "" } /^\| tiles / { print }' "$out/$profile.md" \
    | if [ "$profile" = still-x2-sr ]; then cat; else sed 1,2d; fi >> "$out/tables/profile-tiles.md.part"
done
mv "$out/tables/profile-tiles.md.part" "$out/tables/profile-tiles.md"
