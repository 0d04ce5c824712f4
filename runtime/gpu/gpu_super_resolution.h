// Super resolution on a GPU: the passes of runtime/super_resolution.h as compute shaders.
//
// A port takes the shaders, FrameNumbers and the order of passes in Process; an engine binds its
// own images in place of the uploads here. docs/GPU.md lists passes, resources and formats.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/gpu/vulkan_device.h"
#include "runtime/super_resolution.h"

namespace warplut {

// How a renderer stores motion and depth.
struct InputConventions {
  // From stored motion to render pixels, from the frame before to this one, y down: (width, height)
  // for UV, half of it for NDC, with signs for the direction and for y up.
  float motion_scale_x = 1, motion_scale_y = 1;
  // The depth in units of the far plane is depth_a * z, or of a depth buffer
  // 1 / (depth_a + depth_b * z).
  bool depth_buffer = false;
  float depth_a = 1, depth_b = 0;

  // A depth buffer with 1 at the far plane, or with reversed depth 0. near < far.
  static InputConventions DepthBuffer(float near_plane, float far_plane, bool reversed);
};

struct PassTime {
  std::string pass;
  double milliseconds = 0;
};

class GpuSuperResolution {
 public:
  // Whether the GPU has passes for the options, whose IsValid holds: a history in RGBA16F or
  // RGBA32F. Also false where the device cannot hold the images. *why (if not null) is a sentence.
  static bool IsRunnable(const VulkanDevice& device, const SuperResolutionOptions& options,
                         std::string* why = nullptr);

  // Runnable options. The table is copied. The motion filter runs on the processor, before the
  // upload; with it the conventions must be the default ones. The device outlives the object. A
  // GpuError where memory or a shader cannot be had.
  GpuSuperResolution(const VulkanDevice& device, const SuperResolutionOptions& options,
                     const InputConventions& conventions = {});
  ~GpuSuperResolution();

  // Makes the next frame, as SuperResolution::Process, and waits for it. Colour is taken in any
  // format of RenderedFrame. A GpuError if the device fails.
  //
  // The largest differences from SuperResolution are those of tests/runtime/gpu.
  void Process(const RenderedFrame& frame, const MutableImageView& out);

  // Forgets the history: the next frame is treated as a cut.
  void Reset();

  // Times of the passes of the last frame; empty where the device has no timestamps.
  std::vector<PassTime> Times() const;
  // Bytes of all images and buffers.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
