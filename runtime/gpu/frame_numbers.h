// The push constants of the shaders, in their layout (std430). A uniform block, which they are in
// OpenGL ES, is a multiple of 16 bytes.
#pragma once

#include <array>
#include <cstdint>

#include "luts/prefilter.h"
#include "runtime/gpu/input_conventions.h"

namespace warplut {

using GpuInt2 = std::array<std::int32_t, 2>;
using GpuFloat2 = std::array<float, 2>;

inline GpuFloat2 MotionScaleOf(const InputConventions& conventions) {
  return {conventions.motion_scale_x, conventions.motion_scale_y};
}

// As in shaders/super_resolution.glsl.
struct FrameNumbers {
  GpuInt2 render_size, output_size, render_size_before;
  GpuFloat2 jitter, jitter_before;
  GpuFloat2 motion_scale;
  float depth_a, depth_b;
  float depth_threshold, blend_a, blend_b, clamp_gamma;
  float gate_width, settled_distance, least_step, residual_slack;
  float filter_parameter, most_smoothing, variance_unit;
  std::int32_t has_history;
  GpuInt2 padding;
};
static_assert(sizeof(FrameNumbers) == 112);

// As in shaders/generation.glsl.
struct GenerationNumbers {
  GpuInt2 output_size;
  GpuFloat2 motion_scale;
  float depth_a, depth_b;
  float depth_threshold, brightness_threshold;
  float gate_width, filter_parameter;
  float alpha;
  std::int32_t counts_motion0;
};
static_assert(sizeof(GenerationNumbers) == 48);

// As in shaders/motion_filter.glsl.
struct MotionFilterNumbers {
  GpuInt2 size;
  GpuFloat2 motion_scale;
  float depth_a, depth_b;
  float limit;
  std::int32_t sample_step;
};
static_assert(sizeof(MotionFilterNumbers) == 32);

// As in shaders/warp.comp.
struct WarpNumbers {
  GpuInt2 output_size;
  float filter_parameter, padding;
};
static_assert(sizeof(WarpNumbers) == 16);

// As in shaders/prefilter.comp.
struct PrefilterNumbers {
  GpuInt2 size;
  std::int32_t along_x, reach;
  float pole;
  std::array<float, 3> padding;
  std::array<float, kLargestFirReach + 1> taps;
};
static_assert(sizeof(PrefilterNumbers) == 64);

}  // namespace warplut
