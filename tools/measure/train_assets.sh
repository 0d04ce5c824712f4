#!/bin/sh
# Trains and bakes the tables that ship: luts/fits and luts/baked, one for each upscale factor, on
# the training scenes. usage: tools/measure/train_assets.sh [OBJECTIVE [FOLDER [SCALE...]]]
#   OBJECTIVE  iir (default): warplut_iir_xSCALE, with a recursive prefilter; warp: warplut_xSCALE;
#              sr: warplut_sr_xSCALE; t24, t36: warplut_t24_xSCALE and warplut_t36_xSCALE, of 24 and
#              36 taps without a prefilter
#   FOLDER     where the training images are rendered, or were before (default: out/assets)
#   SCALE      which factors (default: 1.3, 1.5, 1.7 and 2; of t24 and t36 2 alone)
# Needs the release build (tools/quickstart.sh makes it). Without time limits, so that the fits do
# not depend on the machine's speed.
set -eu
cd "$(dirname "$0")/../.."
objective=${1:-iir}
scales='1.3 1.5 1.7 2'
case $objective in
  iir) prefix=warplut_iir_x objective=warp size='--prefilter iir' ;;
  warp) prefix=warplut_x size='--prefilter none --pan-share 0' ;;
  sr) prefix=warplut_sr_x size='--prefilter none --crops 14 --stages 2 --iterations 24 --blend-a 0.85 --blend-b 1' ;;
  t24 | t36)
    prefix=warplut_${objective}_x size="--prefilter none --taps ${objective#t} --gain-bound 1.0095" scales=2
    objective=warp
    ;;
  *) echo "$0: the objective is '$objective'; expected iir, warp, sr, t24 or t36" >&2; exit 2 ;;
esac
if [ $# -gt 0 ]; then shift; fi
out=${1:-out/assets}
if [ $# -gt 0 ]; then shift; fi
# shellcheck disable=SC2086  # scales is a list of words
if [ $# -eq 0 ]; then set -- $scales; fi
warplut=${WARPLUT:-build/release/tools/warplut}

mkdir -p "$out" luts/fits luts/baked
"$warplut" dataset render training --out "$out/training" --width 960 --height 540 --frames 3 --samples 16 \
  --streams color,reference > "$out/render.log"
for scale in "$@"; do
  name=$prefix$(echo "$scale" | tr . _)
  echo "-- $name"
  # shellcheck disable=SC2086  # size is a list of words
  "$warplut" train --objective "$objective" $size --scale "$scale" --data "$out"/training/* --out "luts/fits/$name.json"
  "$warplut" bake "luts/fits/$name.json" --out luts/baked
  for other in png bin dds ktx2 glsl hlsl test.json; do rm -f "luts/baked/$name.$other"; done
done
