// Super resolution on a GPU: the passes of runtime/super_resolution.h as compute shaders.
//
// A port takes the shaders, FrameNumbers and the order of passes in Process; an engine binds its
// own images in place of the uploads here. docs/GPU.md lists passes, resources and formats.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/gpu/gpu_workspace.h"
#include "runtime/gpu/input_conventions.h"
#include "runtime/super_resolution.h"

namespace warplut {

class GpuSuperResolution {
 public:
  // Whether the GPU has passes for the options, whose IsValid holds: a history in RGBA16F or
  // RGBA32F, and no peer. Also false where the device cannot hold the images. *why (if not null) is
  // a sentence.
  static bool IsRunnable(const GpuDevice& device, const SuperResolutionOptions& options,
                         std::string* why = nullptr);

  // Runnable options and valid conventions. The table is copied. `makes_geometry`: Geometry will be
  // called, which takes 20 bytes per output pixel. The device outlives the object. A GpuError where
  // memory or a shader cannot be had.
  GpuSuperResolution(const GpuDevice& device, const SuperResolutionOptions& options,
                     const InputConventions& conventions = {}, bool makes_geometry = false);
  ~GpuSuperResolution();

  // Makes the next frame, as SuperResolution::Process, and waits for it. Colour is taken in any
  // format of RenderedFrame. A GpuError if the device fails.
  //
  // The largest differences from SuperResolution are those of tests/runtime/gpu.
  void Process(const RenderedFrame& frame, const MutableImageView& out);

  // Depth and motion of the last frame on the output grid, as SuperResolution::Geometry: one pass
  // more, at each call. The views end at the next call.
  OutputGeometry Geometry();

  // As SuperResolution::SetRenderSize: the size of rendered frames from the next one on, for which
  // IsRenderSize holds. The history is kept.
  void SetRenderSize(int width, int height);
  bool IsRenderSize(int width, int height, std::string* why = nullptr) const;

  // Forgets the history: the next frame is treated as a cut.
  void Reset();

  // Times of the passes of the last Process or Geometry; empty where the device has no timestamps.
  std::vector<PassTime> Times() const;
  // Bytes of all images and buffers.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
