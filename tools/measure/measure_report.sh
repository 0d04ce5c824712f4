#!/bin/sh
# Makes the report on the built-in scenes and puts its tables and plots into docs/.
# usage: tools/measure/measure_report.sh [--quick] OUT
#   OUT   the report: OUT/index.html
# The program is build/release/tools/warplut, or $WARPLUT.
set -eu

quick=
if [ "${1:-}" = --quick ]; then
  quick=--quick
  shift
fi
if [ $# -ne 1 ]; then
  echo "usage: tools/measure/measure_report.sh [--quick] OUT" >&2
  exit 1
fi
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
warplut=${WARPLUT:-build/release/tools/warplut}

code=0
# shellcheck disable=SC2086 # empty or one option
"$warplut" report --out "$out" $quick || code=$?
if [ "$code" -ne 0 ] && [ "$code" -ne 3 ]; then exit "$code"; fi
tools/measure/update_tables.sh "$out/tables"
mkdir -p docs/plots
for plot in pipelines-small kernels-rgba16f; do
  if [ -f "$out/plots/$plot.svg" ]; then cp "$out/plots/$plot.svg" "docs/plots/$plot.svg"; fi
done
exit "$code"
