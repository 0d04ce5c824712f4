// The shaders, compiled by the build (runtime/gpu/CMakeLists.txt).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "runtime/image_view.h"

// Every shader: its enumerator and the name of its file in runtime/gpu/shaders.
#define WARPLUT_SHADERS(X)          \
  X(kPrefilter, prefilter)          \
  X(kCamera, camera)                \
  X(kMotionFilter, motion_filter)   \
  X(kSamples, samples)              \
  X(kPredict, predict)              \
  X(kResidual, residual)            \
  X(kAliasing, aliasing)            \
  X(kUpdate, update)                \
  X(kReactiveReach, reactive_reach) \
  X(kDepthRange, depth_range)       \
  X(kGeometry, geometry)            \
  X(kEncode, encode)                \
  X(kSplat, splat)                  \
  X(kGenerate, generate)            \
  X(kWarp, warp)

namespace warplut {

#define WARPLUT_ENUMERATOR(enumerator, file) enumerator,
enum class Shader : std::uint8_t { WARPLUT_SHADERS(WARPLUT_ENUMERATOR) };
#undef WARPLUT_ENUMERATOR

// The SPIR-V for images of this format: kRgba16F or kRgba32F. Where the build has Vulkan.
std::span<const std::uint32_t> SpirvOf(Shader shader, PixelFormat format);

// The same as GLSL ES 3.10, push constants as a uniform block. Where the build has OpenGL ES.
std::string_view EsslOf(Shader shader, PixelFormat format);

}  // namespace warplut
