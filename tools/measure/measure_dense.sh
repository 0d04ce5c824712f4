#!/bin/sh
# Measures the tables of docs/results/dense.md and leaves them for tools/measure/update_tables.sh,
# with pictures of what was judged. usage: tools/measure/measure_dense.sh OUT [SCENE...]
#   OUT          the tables go to OUT/tables, the pictures to OUT/pictures
#   SCENE...     the scenes; without one all
# The program is build/release/tools/warplut, or $WARPLUT.
set -eu
if [ $# -lt 1 ]; then
  echo "usage: tools/measure/measure_dense.sh OUT [SCENE...]" >&2
  exit 1
fi
folder=$1
shift
scenes=${*:-all}
set -- "$folder"
# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"

# shellcheck disable=SC2086 # a list of names
"$warplut" dense $scenes --width 240 --height 136 --speed 6 --samples 16 --warm-up 48 --frames 8 \
  --pictures "$out/pictures" --markdown > "$out/dense.md"
# The tables of the scenes, each behind an empty line, and their mean at the end.
awk -v out="$out/tables" 'BEGIN { RS = ""; ORS = "\n" }
  /^\| mean / { print > (out "/dense-mean.md"); next }
  { if (NR > 1) print "" > (out "/dense-scenes.md"); print > (out "/dense-scenes.md") }' "$out/dense.md"

"$warplut" dense --sweep --width 96 --height 96 --samples 16 --warm-up 16 --frames 8 --markdown > "$out/sweep.md"
awk -v out="$out/tables" 'BEGIN { RS = ""; ORS = "\n" }
  { print > (out (NR == 1 ? "/dense-sweep.md" : "/dense-rules.md")) }' "$out/sweep.md"
