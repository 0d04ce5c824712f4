#include "runtime/gpu/shader_code.h"
#include "shaders/spirv.h"  // written by the build

namespace warplut {

std::span<const std::uint32_t> SpirvOf(Shader shader, PixelFormat format) {
  using Code = std::span<const std::uint32_t>;
  const bool half = format == PixelFormat::kRgba16F;
  switch (shader) {
#define WARPLUT_CASE(enumerator, file) \
  case Shader::enumerator:             \
    return half ? Code(file##_rgba16f) : Code(file##_rgba32f);
    WARPLUT_SHADERS(WARPLUT_CASE)
#undef WARPLUT_CASE
  }
  return {};
}

}  // namespace warplut
