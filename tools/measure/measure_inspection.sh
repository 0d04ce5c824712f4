#!/bin/sh
# Measures docs/results/inspect.md: exports built-in scenes under 64 and more conventions, each with
# a manifest that states the usual one, and counts how often `dataset inspect --write` names the
# convention. usage: tools/measure/measure_inspection.sh [--data DIR] OUT [SCENE...]
set -eu
scenes=
if [ "${1:-}" = --data ]; then
  data_option="--data $2"
  shift 2
else
  data_option=
fi
if [ $# -lt 1 ]; then
  echo "usage: tools/measure/measure_inspection.sh [--data DIR] OUT [SCENE...]" >&2
  exit 1
fi
folder=$1
shift
scenes=${*:-still courtyard street meadow machinery plaza gallery harbour colonnade}
# shellcheck disable=SC2086 # an option and its value
set -- $data_option "$folder"
# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"

# The manifest of $1 with the fields of motion that the files are then said to have: the frames stay
# as they are, what is stated is another convention. $2 units, $3 direction, $4 y, $5 channels,
# $6 sign of the jitter's x, $7 of its y.
restate() {
  sed -e "/^  \"motion\"/s/\"units\":\"[a-z]*\"/\"units\":\"$2\"/" \
    -e "/^  \"motion\"/s/\"direction\":\"[a-z-]*\"/\"direction\":\"$3\"/" \
    -e "/^  \"motion\"/s/\"y\":\"[a-z]*\"/\"y\":\"$4\"/" \
    -e "/^  \"motion\"/s/\"channels\":\[[^]]*\]/\"channels\":[$5]/" "$1" |
    awk -v sx="$6" -v sy="$7" '/^  "offsets"/ {
        rest = $0; out = ""
        while (match(rest, /\[-?[0-9.e-]+,-?[0-9.e-]+\]/)) {
          pair = substr(rest, RSTART + 1, RLENGTH - 2); split(pair, v, ",")
          out = out substr(rest, 1, RSTART - 1) sprintf("[%.17g,%.17g]", sx * v[1], sy * v[2])
          rest = substr(rest, RSTART + RLENGTH)
        }
        print out rest; next }
      { print }'
}

# line FIELD MANIFEST: the line of a field.
line() {
  sed -n "/^  \"$1\"/p" "$2"
}

table=$out/tables/inspect-exports.md
echo "| scene | exports | motion named | jitter named | wrong | cannot tell |" > "$table"
echo "|---|---:|---:|---:|---:|---:|" >> "$table"
for scene in $scenes; do
  render_missing "$scene" "$out" --width 320 --height 180 --frames 9 --samples 4
  manifest=$out/$scene/sequence.json
  original=$out/$scene/original.json
  [ -f "$original" ] || cp "$manifest" "$original"
  exports=0 motion=0 jitter=0 wrong=0 unknown=0
  for units in pixels uv; do
    for direction in previous-to-current current-to-previous; do
      for y in down up; do
        for channels in '"X","Y"' '"Y","X"'; do
          for sign in '1 1' '-1 -1' '1 -1' '-1 1'; do
            # shellcheck disable=SC2086 # two signs
            restate "$original" $units $direction $y "$channels" $sign > "$manifest"
            "$warplut" dataset inspect "$out/$scene" --json --only questions \
              --write "$out/$scene/found.json" > "$out/$scene/inspect.txt" 2> /dev/null || [ $? -eq 3 ]
            exports=$((exports + 1))
            found=$out/$scene/found.json
            if [ "$(line motion "$found")" = "$(line motion "$original")" ]; then
              motion=$((motion + 1))
            elif [ "$(line motion "$found")" = "$(line motion "$manifest")" ]; then
              unknown=$((unknown + 1))
            else
              wrong=$((wrong + 1))
            fi
            if [ "$(line offsets "$found")" = "$(line offsets "$original")" ]; then
              jitter=$((jitter + 1))
            fi
          done
        done
      done
    done
  done
  cp "$original" "$manifest"
  echo "| $scene | $exports | $motion | $jitter | $wrong | $unknown |" >> "$table"
  tail -n 1 "$table"
done
