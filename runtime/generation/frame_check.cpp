#include "runtime/generation/frame_check.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "runtime/motion_filter.h"

namespace warplut {
namespace {

bool Refuse(const std::string& sentence, std::string* why) {
  if (why != nullptr) *why = sentence;
  return false;
}

std::string Size(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

// Whether `view` is an image of the size of the options with one of the formats that have four channels, or R32F.
template <class Void>
bool IsImage(const char* name, const BasicImageView<Void>& view, const FrameGenerationOptions& o,
             bool depth, std::string* why) {
  const std::string what = name;
  if (view.data == nullptr) return Refuse(what + " has no data.", why);
  if (view.width != o.width || view.height != o.height) {
    return Refuse(what + " is " + Size(view.width, view.height) + "; expected " +
                      Size(o.width, o.height) + ".",
                  why);
  }
  if ((view.format == PixelFormat::kR32F) != depth) {
    return Refuse(what + " has the format " + Name(view.format) + "; expected " +
                      (depth ? "r32f." : "rgba8, rgba16f or rgba32f."),
                  why);
  }
  const int bytes = BytesPerPixel(view.format);
  const int channel = bytes / Channels(view.format);
  if (view.stride < std::ptrdiff_t{view.width} * bytes || view.stride % channel != 0) {
    return Refuse(what + " has a stride of " + std::to_string(view.stride) +
                      " bytes; expected at least a row of whole channels.",
                  why);
  }
  return true;
}

bool IsMotion(const char* name, const MotionView& view, const FrameGenerationOptions& o,
              std::string* why) {
  const std::string what = name;
  if (view.xy == nullptr) return Refuse(what + " has no data.", why);
  if (view.width != o.width || view.height != o.height) {
    return Refuse(what + " is " + Size(view.width, view.height) + "; expected " +
                      Size(o.width, o.height) + ".",
                  why);
  }
  constexpr auto kFloat = static_cast<std::ptrdiff_t>(sizeof(float));
  if (view.stride < std::ptrdiff_t{view.width} * 2 * kFloat || view.stride % kFloat != 0) {
    return Refuse(what + " has a stride of " + std::to_string(view.stride) +
                      " bytes; expected at least a row of whole floats.",
                  why);
  }
  return true;
}

}  // namespace

bool FrameGenerationOptions::IsValid(std::string* why) const {
  if (width < 1 || height < 1 || width > kLargestSize || height > kLargestSize) {
    return Refuse("The frames are " + Size(width, height) + "; expected 1 to " +
                      std::to_string(kLargestSize) + " pixels in each axis.",
                  why);
  }
  if (std::int64_t{width} * height > std::numeric_limits<std::int32_t>::max()) {
    return Refuse("The frames are " + Size(width, height) + "; expected less than 2^31 pixels.",
                  why);
  }
  if (!(gate_width >= 0.0f && gate_width <= 1.0f)) {
    return Refuse("gate_width is " + std::to_string(gate_width) + "; expected 0 to 1.", why);
  }
  if (motion_filter && !MotionFilterOptions{motion_filter_limit}.IsValid(why)) return false;
  const char* reason = nullptr;
  if (!warp.IsValid(&reason)) return Refuse(std::string("Warp: ") + reason + ".", why);
  return parameters.IsValid(why);
}

bool AreGenerable(const FrameGenerationOptions& o, const DisplayedFrame& frame0,
                  const DisplayedFrame& frame1, float alpha, const MutableImageView& out,
                  std::string* why) {
  if (!(alpha > 0.0f && alpha < 1.0f)) {
    return Refuse("alpha is " + std::to_string(alpha) + "; expected it between 0 and 1.", why);
  }
  if (frame0.color.data != nullptr &&
      !IsImage("The colour of frame 0", frame0.color, o, false, why)) {
    return false;
  }
  return IsImage("The depth of frame 0", frame0.depth, o, true, why) &&
         IsMotion("The motion of frame 0", frame0.motion, o, why) &&
         IsImage("The colour of frame 1", frame1.color, o, false, why) &&
         IsImage("The depth of frame 1", frame1.depth, o, true, why) &&
         IsMotion("The motion of frame 1", frame1.motion, o, why) &&
         IsImage("The output", out, o, false, why);
}

}  // namespace warplut
