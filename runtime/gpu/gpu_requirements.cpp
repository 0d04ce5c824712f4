#include <algorithm>

#include "runtime/configuration/chosen.h"
#include "runtime/gpu/gpu_frame_generation.h"
#include "runtime/gpu/gpu_super_resolution.h"

namespace warplut {
namespace {

bool Refused(const std::string& sentence, std::string* why) {
  if (why != nullptr) *why = sentence;
  return false;
}

constexpr const char* kNoPeers =
    "the options name a peer; the GPU has the passes of super resolution and frame generation";

// Whether the device holds images of this size and stores to those of the formats.
bool Holds(const GpuDevice& device, int width, int height, PixelFormat format, std::string* why) {
  // Positions are whole numbers below 2^31 (shaders/super_resolution.glsl).
  constexpr int kLargestExact = 1 << 14;
  const int most = std::min(device.largest_image(), kLargestExact);
  if (std::max(width, height) > most) {
    return Refused("the output is " + std::to_string(width) + " x " + std::to_string(height) +
                       "; the device " + device.name() + " takes sides of at most " +
                       std::to_string(most),
                   why);
  }
  for (const TexelFormat needed : {TexelFormatOf(format), TexelFormat::kR32F}) {
    if (!device.CanStore(needed)) {
      return Refused("the device " + device.name() + " cannot store images of the format " +
                         Name(needed) + ", which the passes need",
                     why);
    }
  }
  return true;
}

}  // namespace

bool GpuSuperResolution::IsRunnable(const GpuDevice& device, const SuperResolutionOptions& options,
                                    std::string* why) {
  if (options.peer != nullptr) return Refused(kNoPeers, why);
  if (options.coherent_share > 0) {
    return Refused(
        "the options have a share of coherent residuals; the GPU has super resolution without one",
        why);
  }
  const PixelFormat format = HistoryFormatOf(options);
  if (format != PixelFormat::kRgba16F && format != PixelFormat::kRgba32F) {
    return Refused(
        std::string("the history format is ") + Name(format) + "; the GPU takes rgba16f or rgba32f",
        why);
  }
  return Holds(device, options.output_width, options.output_height, format, why);
}

bool GpuFrameGeneration::IsRunnable(const GpuDevice& device, const FrameGenerationOptions& options,
                                    std::string* why) {
  if (options.peer != nullptr) return Refused(kNoPeers, why);
  const MotionModel model = ModelOf(options);
  if (model != MotionModel::kLinear && model != MotionModel::kQuadratic &&
      model != MotionModel::kPerspective) {
    return Refused("the motion model is " + std::to_string(static_cast<int>(model)) +
                       "; the GPU has linear, quadratic and perspective",
                   why);
  }
  if (!Holds(device, options.width, options.height, PixelFormat::kRgba32F, why)) return false;
  const std::size_t keys = SplatKeyBytes(options);
  if (keys > device.largest_buffer()) {
    return Refused("the keys of splatting take " + std::to_string(keys) + " bytes; the device " +
                       device.name() + " takes buffers of at most " +
                       std::to_string(device.largest_buffer()),
                   why);
  }
  return true;
}

}  // namespace warplut
