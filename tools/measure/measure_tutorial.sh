#!/bin/sh
# Runs the commands of docs/TUTORIAL.md in their order, leaves their output for
# tools/measure/update_tables.sh and makes the pictures of the page.
# usage: tools/measure/measure_tutorial.sh OUT
#   OUT   the folder that the commands work in; the outputs go to OUT/tables
# The program is build/release/tools/warplut, or $WARPLUT. A few minutes on two cores.
set -eu

if [ $# -ne 1 ]; then
  echo "usage: tools/measure/measure_tutorial.sh OUT" >&2
  exit 1
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
program=$(cd "$root" && realpath "${WARPLUT:-build/release/tools/warplut}")
mkdir -p "$1/tables"
cd "$1"
rm -rf frames pictures view
ln -sfn "$root/luts" luts

# The commands below are run as they are shown.
# shellcheck disable=SC2317
warplut() { "$program" "$@"; }

# show TABLE LINES COMMAND: runs COMMAND; the table is the command and the first LINES lines of its
# output.
show() {
  echo "-- $1"
  eval "$3" > "$1.txt"
  {
    echo '```'
    echo "\$ $3"
    cut -c 1-120 "$1.txt" | sed 's/ *$//' | head -n "$2"
    if [ "$(wc -l < "$1.txt")" -gt "$2" ]; then echo '...'; fi
    echo '```'
  } > "tables/tutorial-$1.md"
}

for scene in plaza colonnade; do
  warplut dataset render "$scene" --out my --width 320 --height 180 --frames 9 > /dev/null
done
show render 9 'warplut dataset render street --out my --width 320 --height 180 --frames 9'
show inspect 27 'warplut dataset inspect my/street'
show judge 7 'warplut judge --sequence my/colonnade --modes sr,i \
    --lut luts/baked/warplut_iir_x2.json --pictures pictures'
show view 20 'warplut view --sequence my/colonnade --modes sr,bilinear \
    --lut luts/baked/warplut_iir_x2.json --out view'
show payoff 60 'warplut judge --sequence my/colonnade --modes sr --lut luts/baked/warplut_iir_x2.json \
    --against bilinear,catmull-rom,keys:-0.65,spline:1/84'
show train 9 'warplut train --scale 2 --data my/street my/plaza --out own_x2.json \
    --crops 8 --stages 2 --iterations 8'
show bake 16 'warplut bake own_x2.json --out baked'
show header 8 "grep --after-context 7 Certificate baked/own_x2.h"
show warps 9 'warplut eval --lut baked/own_x2.json --images my/colonnade --warps 6,24 \
    --against catmull-rom,spline:1/84'
show calibrate 19 'warplut calibrate --sequence my/street my/plaza my/colonnade --hold-out colonnade \
    --modes sr --lut baked/own_x2.json --max-pixels 10000 --starts 0 --out PARAMS.json'
show run 9 'warplut run --mode sr --sequence my/colonnade --lut baked/own_x2.json \
    --params PARAMS.json --out frames'
show compare 14 'warplut compare frames my/colonnade --border 5'
show profile 29 'warplut profile --sequence my/street my/plaza --mode sr \
    --lut baked/own_x2.json --out PIPELINE.h'
show pipeline 40 "grep --invert-match '^//' PIPELINE.h"

cp pictures/colonnade-0008-error.png "$root/docs/pictures/tutorial-judge.png"
cp view/worst-sr.png "$root/docs/pictures/tutorial-view.png"
cp baked/own_x2.png "$root/docs/pictures/tutorial-table.png"
