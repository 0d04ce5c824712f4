#!/bin/sh
# Translates the compute shaders of the build into the languages of engines, and checks each result
# where a compiler for it is installed. usage: tools/translate_shaders.sh OUT [BUILD]
#   OUT     folder for the files: NAME.spv (Vulkan 1.1), NAME.es310.comp (OpenGL ES 3.1),
#           NAME.gl430.comp (OpenGL 4.3), NAME.hlsl (shader model 6), NAME.metal (Metal 2);
#           push constants are uniform block 0 of both OpenGLs
#   BUILD   build with GPU passes (default: build/release)
# Ends with 77 if spirv-cross or spirv-val (Debian: spirv-cross, spirv-tools) is missing. HLSL is
# checked by glslangValidator, as DXC and FXC are no Debian packages; Metal is not checked.
set -eu
case "${1:-}" in
  '' | -*)
    echo "usage: tools/translate_shaders.sh OUT [BUILD]" >&2
    exit 1
    ;;
esac
out=$1
build=${2:-$(dirname "$0")/../build/release}
shaders=$build/runtime/gpu/shaders
essl_options=$(cat "$(dirname "$0")/../runtime/gpu/gles/essl_options.txt")
for tool in spirv-cross spirv-val spirv-opt glslangValidator; do
  if ! command -v "$tool" > /dev/null; then
    echo "SKIPPED: $tool is not installed"
    exit 77
  fi
done
if ! [ -f "$shaders/predict_rgba16f.spv" ]; then
  echo "translate_shaders.sh: $shaders has no shaders; expected a build with GPU passes" >&2
  exit 2
fi
mkdir -p "$out"
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# check COMMAND...: runs it; its output counts only if it fails.
check() {
  if ! "$@" > "$log" 2>&1; then
    cat "$log" >&2
    echo "translate_shaders.sh: failed: $*" >&2
    exit 2
  fi
}

count=0
for spv in "$shaders"/*.spv; do
  name=$(basename "$spv" .spv)
  check spirv-val --target-env vulkan1.1 "$spv"
  check spirv-opt --target-env=vulkan1.1 -O "$spv" -o "$out/$name.spv"
  check spirv-val --target-env vulkan1.1 "$out/$name.spv"
  # shellcheck disable=SC2086
  check spirv-cross "$spv" $essl_options --output "$out/$name.es310.comp"
  check glslangValidator "$out/$name.es310.comp"
  check spirv-cross "$spv" --no-es --version 430 --glsl-emit-push-constant-as-ubo --output "$out/$name.gl430.comp"
  check glslangValidator "$out/$name.gl430.comp"
  check spirv-cross "$spv" --hlsl --shader-model 60 --output "$out/$name.hlsl"
  check glslangValidator -D -e main -S comp -V "$out/$name.hlsl" -o "$log.spv"
  rm -f "$log.spv"
  check spirv-cross "$spv" --msl --msl-version 20000 --output "$out/$name.metal"
  count=$((count + 1))
done
echo "$count shaders in $out"
