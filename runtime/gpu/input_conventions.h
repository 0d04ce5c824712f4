// How a renderer stores colour, motion and depth.
#pragma once

#include <string>

#include "runtime/gpu/texel_format.h"

namespace warplut {

struct InputConventions {
  // Formats of the images that shaders sample. The host of warplut converts what it is given to
  // them; an engine has its own images.
  //   color   rgba32f, rgba16f, rgba8, r11g11b10f
  //   motion  rg32f, rg16f
  //   the reactive mask  r32f, r16f, r8
  TexelFormat color_format = TexelFormat::kRgba32F;
  TexelFormat motion_format = TexelFormat::kRg32F;
  TexelFormat reactive_format = TexelFormat::kR32F;
  // From stored motion to pixels of its grid, from the frame before to this one, y down: (width,
  // height) for UV, half of it for NDC, with signs for the direction and for y up.
  float motion_scale_x = 1, motion_scale_y = 1;
  // The depth in units of the far plane is depth_a * z, or of a depth buffer
  // 1 / (depth_a + depth_b * z).
  bool depth_buffer = false;
  float depth_a = 1, depth_b = 0;

  // Whether the formats are among those above; *why (if not null) is a sentence.
  bool IsValid(std::string* why = nullptr) const;

  // A depth buffer with 1 at the far plane, or with reversed depth 0. near < far.
  static InputConventions DepthBuffer(float near_plane, float far_plane, bool reversed);
};

}  // namespace warplut
