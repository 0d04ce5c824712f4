// The shaders as SPIR-V, compiled by the build (runtime/gpu/CMakeLists.txt).
#pragma once

#include <cstdint>
#include <span>

#include "runtime/image_view.h"

namespace warplut {

enum class Shader : std::uint8_t {
  kPrefilter,
  kSamples,
  kPredict,
  kResidual,
  kAliasing,
  kUpdate,
  kDepthRange,
  kGeometry,
  kEncode,
  kSplat,
  kGenerate
};

// The code for images of this format: kRgba16F or kRgba32F.
std::span<const std::uint32_t> CodeOf(Shader shader, PixelFormat format);

}  // namespace warplut
