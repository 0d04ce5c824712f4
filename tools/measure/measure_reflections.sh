#!/bin/sh
# Measures the tables of docs/results/reflections.md and leaves them for
# tools/measure/update_tables.sh. usage: tools/measure/measure_reflections.sh OUT [SCENE...]
#   OUT          the tables go to OUT/tables
#   SCENE...     two scenes or more; without one all but still, which is flat
# The program is build/release/tools/warplut, or $WARPLUT.
set -eu
if [ $# -lt 1 ]; then
  echo "usage: tools/measure/measure_reflections.sh OUT [SCENE...]" >&2
  exit 1
fi
folder=$1
shift
scenes=${*:-street gallery harbour courtyard meadow plaza colonnade machinery}
set -- "$folder"
# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"

# shellcheck disable=SC2086 # a list of names
"$warplut" reflections $scenes --markdown > "$out/reflections.md"
# The tables of the scenes, each behind an empty line, and their mean at the end.
awk -v out="$out/tables" 'BEGIN { RS = ""; ORS = "\n" }
  /^\| mean, / { print > (out "/reflections-mean.md"); next }
  { if (NR > 1) print "" > (out "/reflections-scenes.md"); print > (out "/reflections-scenes.md") }' \
  "$out/reflections.md"
