#include "runtime/gpu/shader_code.h"

#include "shaders/aliasing_rgba16f.h"
#include "shaders/aliasing_rgba32f.h"
#include "shaders/depth_range_rgba16f.h"
#include "shaders/depth_range_rgba32f.h"
#include "shaders/encode_rgba16f.h"
#include "shaders/encode_rgba32f.h"
#include "shaders/generate_rgba16f.h"
#include "shaders/generate_rgba32f.h"
#include "shaders/geometry_rgba16f.h"
#include "shaders/geometry_rgba32f.h"
#include "shaders/predict_rgba16f.h"
#include "shaders/predict_rgba32f.h"
#include "shaders/prefilter_rgba16f.h"
#include "shaders/prefilter_rgba32f.h"
#include "shaders/residual_rgba16f.h"
#include "shaders/residual_rgba32f.h"
#include "shaders/samples_rgba16f.h"
#include "shaders/samples_rgba32f.h"
#include "shaders/splat_rgba16f.h"
#include "shaders/splat_rgba32f.h"
#include "shaders/update_rgba16f.h"
#include "shaders/update_rgba32f.h"

namespace warplut {

std::span<const std::uint32_t> CodeOf(Shader shader, PixelFormat format) {
  using Code = std::span<const std::uint32_t>;
  const bool half = format == PixelFormat::kRgba16F;
  switch (shader) {
    case Shader::kPrefilter:
      return half ? Code(prefilter_rgba16f) : Code(prefilter_rgba32f);
    case Shader::kSamples:
      return half ? Code(samples_rgba16f) : Code(samples_rgba32f);
    case Shader::kPredict:
      return half ? Code(predict_rgba16f) : Code(predict_rgba32f);
    case Shader::kResidual:
      return half ? Code(residual_rgba16f) : Code(residual_rgba32f);
    case Shader::kAliasing:
      return half ? Code(aliasing_rgba16f) : Code(aliasing_rgba32f);
    case Shader::kUpdate:
      return half ? Code(update_rgba16f) : Code(update_rgba32f);
    case Shader::kDepthRange:
      return half ? Code(depth_range_rgba16f) : Code(depth_range_rgba32f);
    case Shader::kGeometry:
      return half ? Code(geometry_rgba16f) : Code(geometry_rgba32f);
    case Shader::kEncode:
      return half ? Code(encode_rgba16f) : Code(encode_rgba32f);
    case Shader::kSplat:
      return half ? Code(splat_rgba16f) : Code(splat_rgba32f);
    case Shader::kGenerate:
      return half ? Code(generate_rgba16f) : Code(generate_rgba32f);
  }
  return {};
}

}  // namespace warplut
