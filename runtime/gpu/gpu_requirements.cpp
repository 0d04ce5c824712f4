#include <algorithm>

#include "runtime/configuration/chosen.h"
#include "runtime/gpu/gpu_super_resolution.h"
#include "runtime/gpu/vulkan_resources.h"

namespace warplut {
namespace {

bool Refused(const std::string& sentence, std::string* why) {
  if (why != nullptr) *why = sentence;
  return false;
}

}  // namespace

InputConventions InputConventions::DepthBuffer(float near_plane, float far_plane, bool reversed) {
  const float ratio = far_plane / near_plane;
  InputConventions conventions;
  conventions.depth_buffer = true;
  conventions.depth_a = reversed ? 1.0f : ratio;
  conventions.depth_b = reversed ? ratio - 1 : 1 - ratio;
  return conventions;
}

bool GpuSuperResolution::IsRunnable(const VulkanDevice& device,
                                    const SuperResolutionOptions& options, std::string* why) {
  if (options.peer != nullptr) {
    return Refused("the options name a peer; the GPU has the passes of super resolution alone",
                   why);
  }
  const PixelFormat format = HistoryFormatOf(options);
  if (format != PixelFormat::kRgba16F && format != PixelFormat::kRgba32F) {
    return Refused(
        std::string("the history format is ") + Name(format) + "; the GPU takes rgba16f or rgba32f",
        why);
  }
  const int largest = std::max(options.output_width, options.output_height);
  // Positions are whole numbers below 2^31 (shaders/common.glsl).
  constexpr int kLargestExact = 1 << 14;
  const int most = std::min(device.largest_image(), kLargestExact);
  if (largest > most) {
    return Refused("the output is " + std::to_string(options.output_width) + " x " +
                       std::to_string(options.output_height) + "; the device " + device.name() +
                       " takes sides of at most " + std::to_string(most),
                   why);
  }
  for (const VkFormat needed : {VulkanFormat(format), VK_FORMAT_R32_SFLOAT}) {
    if (!device.CanStore(needed)) {
      return Refused("the device " + device.name() + " cannot store images of the format " +
                         std::to_string(needed) + " of Vulkan, which the passes need",
                     why);
    }
  }
  return true;
}

}  // namespace warplut
