// How a renderer stores colour, motion and depth.
#pragma once

#include <volk.h>

namespace warplut {

struct InputConventions {
  // Formats of the images that shaders sample. The host of warplut converts what it is given to
  // them; an engine has its own images.
  //   color   R32G32B32A32_SFLOAT, R16G16B16A16_SFLOAT, R8G8B8A8_UNORM, B10G11R11_UFLOAT_PACK32
  //   motion  R32G32_SFLOAT, R16G16_SFLOAT
  VkFormat color_format = VK_FORMAT_R32G32B32A32_SFLOAT;
  VkFormat motion_format = VK_FORMAT_R32G32_SFLOAT;
  // From stored motion to pixels of its grid, from the frame before to this one, y down: (width,
  // height) for UV, half of it for NDC, with signs for the direction and for y up.
  float motion_scale_x = 1, motion_scale_y = 1;
  // The depth in units of the far plane is depth_a * z, or of a depth buffer
  // 1 / (depth_a + depth_b * z).
  bool depth_buffer = false;
  float depth_a = 1, depth_b = 0;

  // A depth buffer with 1 at the far plane, or with reversed depth 0. near < far.
  static InputConventions DepthBuffer(float near_plane, float far_plane, bool reversed);
};

}  // namespace warplut
