#!/bin/sh
# Counts the work of the shader warp.comp in its SPIR-V and prints a table. usage:
# tools/measure/count_warp_work.sh [BUILD]
#   BUILD   build with GPU passes (default: build/release)
# The choices of each row are set, loops are unrolled, and each instruction counts once: a fetch of
# a texel, a fetch that filters, floating-point operations of each channel (a fused one as two). The
# copy of a pixel that moves by whole texels is a path of its own and does not count.
set -eu
build=${1:-build/release}
shader=$build/runtime/gpu/shaders/warp_rgba16f.spv
for tool in spirv-opt spirv-dis spirv-as; do
  if ! command -v "$tool" > /dev/null; then
    echo "count_warp_work.sh: $tool is missing; expected Debian's spirv-tools" >&2
    exit 2
  fi
done
if ! [ -f "$shader" ]; then
  echo "count_warp_work.sh: there is no $shader; expected a build with GPU passes" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# Motion RG32F, the image once, the result.
bytes=$((8 + 8 + 8))

# row NAME COPIES CHOICES: CHOICES are "constant_id:value ..." of shaders/formulas.glsl and
# shaders/warp.comp, COPIES the fetches of the path of whole texels.
row() {
  spirv-opt --target-env=vulkan1.1 --set-spec-const-default-value "2:0 5:0 11:false $3" --freeze-spec-const \
    --fold-spec-const-op-composite -O "$shader" -o "$work/set.spv"
  # spirv-opt unrolls loops that ask for it.
  spirv-dis "$work/set.spv" | sed 's/\(OpLoopMerge %[^ ]* %[^ ]*\) .*/\1 Unroll/' > "$work/set.txt"
  spirv-as --target-env spv1.3 "$work/set.txt" -o "$work/marked.spv"
  spirv-opt --target-env=vulkan1.1 --loop-unroll -O "$work/marked.spv" -o "$work/unrolled.spv"
  spirv-dis "$work/unrolled.spv" | awk -v name="$1" -v copies="$2" -v bytes="$bytes" '
    $3 == "OpTypeFloat" { channels[$1] = 1 }
    $3 == "OpTypeVector" && $4 in channels { channels[$1] = $5 }
    $3 == "OpImageFetch" { fetches++ }
    $3 ~ /^OpImageSample/ { filtered++ }
    $1 == "OpLoopMerge" { loops++ }
    $3 ~ /^OpF(Add|Sub|Mul|Div|Negate)$/ || $3 == "OpVectorTimesScalar" { operations += channels[$4] }
    $3 == "OpExtInst" && $4 in channels { operations += ($6 == "Fma" ? 2 : $6 == "FMix" ? 3 : 1) * channels[$4] }
    END {
      if (loops > 0) exit 1
      printf "| %s | %d | %d | %d | %d |\n", name, fetches - copies, filtered, operations, bytes
    }'
}

echo "| warp | fetches | filtered | operations | bytes |"
echo "|---|---:|---:|---:|---:|"
row "table, 16 taps, nearest" 1 "7:3 8:0 9:false 10:4 12:16"
row "table, 16 taps, bilinear" 1 "7:3 8:1 9:false 10:4 12:16"
row "table, 24 taps, bilinear" 1 "7:3 8:1 9:false 10:6 12:16"
row "Catmull-Rom, 16 texels" 1 "7:1 9:false 12:16"
row "Catmull-Rom, 9 fetches" 0 "7:1 9:false 12:9"
row "Catmull-Rom, 5 fetches" 0 "7:1 9:false 12:5"
