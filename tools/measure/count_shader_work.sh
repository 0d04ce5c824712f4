#!/bin/sh
# Counts the work of the compute shaders in their SPIR-V. usage:
# tools/measure/count_shader_work.sh warp | passes | check [BUILD]
#   warp     prints a table of warp.comp: each row has the choices that it names
#   passes   prints a table of all passes with the default choices
#   check    compares the numbers of runtime/gpu/pass_work.cpp with the counts: equal in a pass whose
#            pixels all take one way, at most as large in one that has branches; 1 if they are not
#   BUILD    build with GPU passes (default: build/release)
# The choices are set, loops are unrolled, and each instruction counts once, in whatever branch it is:
# a fetch of a texel, a fetch that filters, floating-point operations of each channel (a fused one as
# two). A loop whose length is found as it runs counts as one turn. Ends with 77 if spirv-opt
# (Debian: spirv-tools) is missing.
set -eu
build=${2:-build/release}
shaders=$build/runtime/gpu/shaders
for tool in spirv-opt spirv-dis spirv-as; do
  if ! command -v "$tool" > /dev/null; then
    echo "SKIPPED: $tool is not installed; expected Debian's spirv-tools"
    exit 77
  fi
done
if ! [ -f "$shaders/warp_rgba16f.spv" ]; then
  echo "count_shader_work.sh: there is no $shaders/warp_rgba16f.spv; expected a build with GPU passes" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# count SHADER CHOICES: prints fetches, filtered fetches, operations, loops that are left. CHOICES are
# "constant_id:value ..." of the shader; others keep the defaults in its source.
count() {
  # spirv-opt takes no empty list.
  spirv-opt --target-env=vulkan1.1 --set-spec-const-default-value "${2:-99:0}" --freeze-spec-const \
    --fold-spec-const-op-composite -O "$shaders/$1_rgba16f.spv" -o "$work/set.spv"
  # spirv-opt unrolls loops that ask for it.
  spirv-dis "$work/set.spv" | sed 's/\(OpLoopMerge %[^ ]* %[^ ]*\) .*/\1 Unroll/' > "$work/set.txt"
  spirv-as --target-env spv1.3 "$work/set.txt" -o "$work/marked.spv"
  spirv-opt --target-env=vulkan1.1 --loop-unroll -O "$work/marked.spv" -o "$work/unrolled.spv"
  spirv-dis "$work/unrolled.spv" | awk '
    $3 == "OpTypeFloat" { channels[$1] = 1 }
    $3 == "OpTypeVector" && $4 in channels { channels[$1] = $5 }
    $3 == "OpImageFetch" { fetches++ }
    $3 ~ /^OpImageSample/ { filtered++ }
    $1 == "OpLoopMerge" { loops++ }
    $3 ~ /^OpF(Add|Sub|Mul|Div|Negate)$/ || $3 == "OpVectorTimesScalar" { operations += channels[$4] }
    $3 == "OpExtInst" && $4 in channels { operations += ($6 == "Fma" ? 2 : $6 == "FMix" ? 3 : 1) * channels[$4] }
    END { print fetches + 0, filtered + 0, operations + 0, loops + 0 }'
}

# Motion RG32F, the image once, the result.
bytes=$((8 + 8 + 8))

# warp_row NAME COPIES CHOICES: COPIES are the fetches of the path of whole texels, which does not count.
warp_row() {
  count warp "2:0 5:0 11:false $3" > "$work/counts"
  read -r fetches filtered operations loops < "$work/counts"
  [ "$loops" -eq 0 ]
  echo "| $1 | $((fetches - $2)) | $filtered | $operations | $bytes |"
}

# pass NAME SHADER CHOICES: "NAME|fetches|operations|loops".
pass() {
  count "$2" "$3" > "$work/counts"
  read -r fetches filtered operations loops < "$work/counts"
  [ "$filtered" -eq 0 ]
  echo "$1|$fetches|$operations|$loops"
}

passes() {
  pass "camera" camera ""
  pass "motion filter" motion_filter ""
  pass "samples" samples ""
  pass "predict" predict ""
  pass "residual" residual ""
  pass "aliasing" aliasing ""
  pass "update" update ""
  pass "depth range" depth_range ""
  pass "reactive reach" reactive_reach ""
  pass "geometry" geometry ""
  pass "splat depth" splat "18:true"
  pass "splat source" splat "18:false"
  pass "interpolate" generate "17:true"
  pass "extrapolate" generate "17:false"
}

case "${1:-}" in
  warp)
    echo "| warp | fetches | filtered | operations | bytes |"
    echo "|---|---:|---:|---:|---:|"
    warp_row "table, 16 taps, nearest" 1 "7:3 8:0 9:false 10:4 12:16"
    warp_row "table, 16 taps, bilinear" 1 "7:3 8:1 9:false 10:4 12:16"
    warp_row "table, 24 taps, bilinear" 1 "7:3 8:1 9:false 10:6 12:16"
    warp_row "Catmull-Rom, 16 texels" 1 "7:1 9:false 12:16"
    warp_row "Catmull-Rom, 9 fetches" 0 "7:1 9:false 12:9"
    warp_row "Catmull-Rom, 5 fetches" 0 "7:1 9:false 12:5"
    ;;
  passes)
    echo "| pass | fetches | operations | loops |"
    echo "|---|---:|---:|---:|"
    passes | awk -F '|' '{ printf "| %s | %d | %d | %d |\n", $1, $2, $3, $4 }'
    ;;
  check)
    passes > "$work/passes"
    "$build/runtime/gpu/gpu_roofline" > "$work/roofline"
    awk -F ' *\\| *' -v one_way="samples,residual,aliasing,depth range" '
      BEGIN { split(one_way, names, ","); for (i in names) exact[names[i]] = missing[names[i]] = 1 }
      FNR == NR { fetches[$1] = $2; operations[$1] = $3; loops[$1] = $4; next }
      !($2 in fetches) { next }
      $2 in exact { delete missing[$2]; wrong = $4 != fetches[$2] || $5 != operations[$2] }
      !($2 in exact) { wrong = loops[$2] == 0 && ($4 > fetches[$2] || $5 > operations[$2]) }
      wrong {
        print $2 ": pass_work.cpp has " $4 " fetches and " $5 " operations, the shader " fetches[$2] " and " \
          operations[$2]
        failed = 1
      }
      END {
        for (name in missing) { print name ": pass_work.cpp has no such pass"; failed = 1 }
        exit failed
      }' "$work/passes" "$work/roofline"
    ;;
  *)
    echo "usage: tools/measure/count_shader_work.sh warp | passes | check [BUILD]" >&2
    exit 1
    ;;
esac
