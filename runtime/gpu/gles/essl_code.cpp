#include "runtime/gpu/shader_code.h"
#include "shaders/essl.h"  // written by the build

namespace warplut {

std::string_view EsslOf(Shader shader, PixelFormat format) {
  const bool half = format == PixelFormat::kRgba16F;
  switch (shader) {
#define WARPLUT_CASE(enumerator, file) \
  case Shader::enumerator:             \
    return half ? file##_rgba16f_essl : file##_rgba32f_essl;
    WARPLUT_SHADERS(WARPLUT_CASE)
#undef WARPLUT_CASE
  }
  return {};
}

}  // namespace warplut
