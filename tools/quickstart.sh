#!/bin/sh
# From a bare Debian to a trained, baked and judged x2 resampler (a table with its prefilter) and a
# calibrated pipeline that uses it, in about 10 minutes on 2 cores.
# usage: tools/quickstart.sh [--data DIR] [OUT]
#   --data DIR   also judge the LUT on the sequences and image folders in DIR
#                (default: $WARPLUT_DATA)
#   OUT          where everything goes (default: out/quickstart)
# Steps that are complete are skipped when it runs again; remove OUT to start anew. Ends with 3 if
# the resampler misses a target, and names the targets that it missed: better than the spline with
# k = 1/84 after 6, 12, 24 and 64 warps by half a pixel, by random offsets and in pans, and by more
# than 0.002 SSIM in the mean of these twelve.
set -eu

data=${WARPLUT_DATA:-}
out=
while [ $# -gt 0 ]; do
  case "$1" in
    --data)
      if [ $# -lt 2 ]; then
        echo "quickstart.sh: --data needs a folder." >&2
        exit 1
      fi
      data=$2
      shift
      ;;
    -*)
      echo "quickstart.sh: '$1' is not an option; expected [--data DIR] [OUT]." >&2
      exit 1
      ;;
    *) out=$1 ;;
  esac
  shift
done
if [ -n "$data" ]; then
  if [ ! -d "$data" ]; then
    echo "quickstart.sh: $data is not a folder." >&2
    exit 1
  fi
  data=$(cd "$data" && pwd)
fi
if [ -n "$out" ]; then
  mkdir -p "$out"
  out=$(cd "$out" && pwd)
fi
cd "$(dirname "$0")/.."
: "${out:=$PWD/out/quickstart}"
mkdir -p "$out/done" "$out/tables"

warplut=build/release/tools/warplut
name=warplut_iir_x2
fitted_clips='street plaza'
judged_clip=colonnade
missed=
newline='
'

begun=$(date +%s)
# step NAME COMMAND...: runs the command unless it was completed before with the same words, and
# tells its time.
step() {
  step_name=$1
  shift
  if [ "$(cat "$out/done/$step_name" 2> /dev/null)" = "$*" ]; then
    echo "-- $step_name: done before"
    return
  fi
  echo "-- $step_name"
  step_begun=$(date +%s)
  "$@"
  echo "$*" > "$out/done/$step_name"
  echo "   $(($(date +%s) - step_begun)) s"
}

build() {
  log=$out/build.log
  if ! { cmake --preset release &&
    cmake --build --preset release --parallel "$(nproc)" --target warplut; } > "$log" 2>&1; then
    tail -n 30 "$log" >&2
    echo "quickstart.sh: the build failed; $log has all of it." >&2
    exit 1
  fi
}

render() { # render SELECTION FRAMES SAMPLES
  "$warplut" dataset render "$1" --out "$out/$1" --width 960 --height 540 --frames "$2" --samples "$3" \
    --streams color,reference > "$out/render-$1.log"
}

# The work is counted in evaluations, so that the result does not depend on the speed of the
# machine.
train() {
  resume=
  if [ -f "$out/$name.json.checkpoint" ]; then resume=--resume; fi
  "$warplut" train --scale 2 --prefilter iir --data "$out"/training/* \
    --out "$out/$name.json" $resume
}

bake() { "$warplut" bake "$out/$name.json" --out "$out/baked"; }

judge() { # judge TABLE IMAGES...
  table=$1
  shift
  code=0
  "$warplut" eval --lut "$out/baked/$name.json" --images "$@" --pictures "$out/pictures" \
    --against catmull-rom,keys:-0.58,spline:1/84 --target spline:1/84,0 --target spline:1/84,0.002,mean \
    --markdown > "$out/tables/$table.part" || code=$?
  case $code in
    0 | 3)
      sed -n 's/^missed: //p' "$out/tables/$table.part" > "$out/tables/$table.missed"
      grep '^|' "$out/tables/$table.part" > "$out/tables/$table.md"
      rm "$out/tables/$table.part"
      ;;
    *) exit "$code" ;;
  esac
}

cost() {
  code=0
  "$warplut" bench warp --repeats 5 --formats rgba8 > "$out/cost.txt" || code=$?
  if [ "$code" -ne 0 ] && [ "$code" -ne 3 ]; then exit "$code"; fi
}

# Clips with every stream: two to calibrate on, one to judge by.
render_clips() {
  for scene in $fitted_clips $judged_clip; do
    "$warplut" dataset render "$scene" --out "$out/clips" --width 640 --height 360 --frames 9 --samples 16 \
      > "$out/render-$scene.log"
  done
}

calibrate() {
  set --
  for scene in $fitted_clips; do set -- "$@" "$out/clips/$scene"; done
  "$warplut" calibrate --sequence "$@" "$out/clips/$judged_clip" --hold-out "$judged_clip" --modes sr,i \
    --lut "$out/baked/$name.json" --max-pixels 40000 --starts 0 --out "$out/params.json" > "$out/calibration.txt"
}

run_pipeline() {
  for mode in sr i; do
    "$warplut" run --mode "$mode" --sequence "$out/clips/$judged_clip" --lut "$out/baked/$name.json" \
      --params "$out/params.json" --out "$out/frames/$mode" > "$out/run-$mode.txt"
  done
}

judge_pipeline() {
  "$warplut" judge --sequence "$out/clips/$judged_clip" --lut "$out/baked/$name.json" --params "$out/params.json" \
    --modes sr,sr-paper,i,i-paper --pictures "$out/pictures" --markdown > "$out/judge-pipeline.txt"
  grep '^|' "$out/judge-pipeline.txt" > "$out/tables/quickstart-pipeline.part"
  mv "$out/tables/quickstart-pipeline.part" "$out/tables/quickstart-pipeline.md"
}

# The example program, compiled against the header that was baked just now instead of the one that
# ships.
example() {
  mkdir -p "$out/include/luts/baked"
  cp "$out/baked/$name.h" "$out/include/luts/baked/"
  "${CXX:-c++}" -std=c++20 -O2 -I "$out/include" -I . runtime/example/warp_example.cpp \
    build/release/runtime/libwarplut_runtime.a -lhwy -pthread -o "$out/warp_example"
  "$out/warp_example"
}

# show TABLE TITLE
show() {
  echo
  echo "$2"
  cat "$out/tables/$1.md"
  if [ -s "$out/tables/$1.missed" ]; then
    missed=$missed$(sed "s/^/  $1, /" "$out/tables/$1.missed")$newline
  fi
}

tools/install_dependencies.sh
echo "-- build"
build
echo "   $(($(date +%s) - begun)) s since the start"
step render-training render training 3 16
step render-held-out render held-out 3 16
step train train
step bake bake
step judge-held-out judge quickstart-held-out "$out"/held-out/*
if [ -n "$data" ]; then
  # Sequences, or folders of images where there are none.
  set -- "$data"/*/sequence.json
  if [ ! -e "$1" ]; then set -- "$data"/*/; fi
  step judge-data judge quickstart-data "$@"
fi
step cost cost
step example example
step render-clips render_clips
step calibrate calibrate
step run-pipeline run_pipeline
step judge-pipeline judge_pipeline

show quickstart-held-out "SSIM on built-in scenes that were held out (the LUT is $name):"
if [ -n "$data" ]; then show quickstart-data "SSIM on the images in $data:"; fi
echo
cat "$out/cost.txt"
echo
echo "Super resolution (sr) and interpolation (i) of the scene $judged_clip, calibrated on $fitted_clips:"
cat "$out/tables/quickstart-pipeline.md"
cat << END

All of it took $(($(date +%s) - begun)) s. Look at
  $out/baked/$name.h      the LUT for a C++ renderer; .json and .exr hold the same table
  $out/baked/$name.png    the LUT as a picture: one tile for each tap, orange positive, blue negative
  $out/params.json        the calibrated parameters; calibration.txt says what they are worth
  $out/frames             frames of super resolution and interpolation
  $out/pictures           original, Catmull-Rom and the LUT after 24 warps; the pipeline beside its baselines
  $out/tables             the tables above
END
if [ -n "$missed" ]; then
  printf '\nMissed targets:\n%s' "$missed"
  exit 3
fi
