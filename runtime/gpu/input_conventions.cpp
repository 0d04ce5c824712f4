#include "runtime/gpu/input_conventions.h"

namespace warplut {

bool InputConventions::IsValid(std::string* why) const {
  std::string reason;
  if (color_format != TexelFormat::kRgba32F && color_format != TexelFormat::kRgba16F &&
      color_format != TexelFormat::kRgba8 && color_format != TexelFormat::kR11G11B10F) {
    reason = std::string("the format of colour is ") + Name(color_format) +
             "; expected rgba32f, rgba16f, rgba8 or r11g11b10f";
  } else if (motion_format != TexelFormat::kRg32F && motion_format != TexelFormat::kRg16F) {
    reason =
        std::string("the format of motion is ") + Name(motion_format) + "; expected rg32f or rg16f";
  } else if (reactive_format != TexelFormat::kR32F && reactive_format != TexelFormat::kR16F &&
             reactive_format != TexelFormat::kR8) {
    reason = std::string("the format of the reactive mask is ") + Name(reactive_format) +
             "; expected r32f, r16f or r8";
  }
  if (why != nullptr) *why = reason;
  return reason.empty();
}

InputConventions InputConventions::DepthBuffer(float near_plane, float far_plane, bool reversed) {
  const float ratio = far_plane / near_plane;
  InputConventions conventions;
  conventions.depth_buffer = true;
  conventions.depth_a = reversed ? 1.0f : ratio;
  conventions.depth_b = reversed ? ratio - 1 : 1 - ratio;
  return conventions;
}

}  // namespace warplut
