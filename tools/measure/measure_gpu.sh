#!/bin/sh
# Makes the tables of docs/results/gpu.md. usage: tools/measure/measure_gpu.sh [BUILD]
#   BUILD   build with GPU passes (default: build/release)
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/release}
tables=$(mktemp -d)
trap 'rm -r "$tables"' EXIT
"$build/runtime/gpu/gpu_roofline" > "$tables/gpu-roofline.md"
tools/measure/count_shader_work.sh check "$build"
tools/measure/count_shader_work.sh passes "$build" > "$tables/gpu-counted.md"
tools/measure/count_shader_work.sh warp "$build" > "$tables/gpu-warp.md"
tools/measure/update_tables.sh "$tables"
