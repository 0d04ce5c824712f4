// Frame generation on a GPU: the passes of runtime/frame_generation.h as compute shaders.
//
// An engine binds its own images in place of the uploads here. docs/GPU.md lists passes, resources
// and formats.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/frame_generation.h"
#include "runtime/gpu/gpu_workspace.h"
#include "runtime/gpu/input_conventions.h"

namespace warplut {

// The format of codes, coefficients and generated frames for colours of this format: RGBA32F for
// itself, RGBA16F for others.
constexpr PixelFormat GeneratedFormat(PixelFormat color) {
  return color == PixelFormat::kRgba32F ? PixelFormat::kRgba32F : PixelFormat::kRgba16F;
}

// Bytes of what arrives at the pixels of a frame; of one pixel where the options do not splat.
std::size_t SplatKeyBytes(const FrameGenerationOptions& options);

class GpuFrameGeneration {
 public:
  // Whether the GPU has passes for the options, whose IsValid holds: a motion model of choices.h,
  // and no peer. Also false where the device cannot hold the images or the keys. *why (if not null)
  // is a sentence.
  static bool IsRunnable(const GpuDevice& device, const FrameGenerationOptions& options,
                         std::string* why = nullptr);

  // Runnable options and valid conventions; `format` is kRgba16F or kRgba32F, that of codes,
  // coefficients and generated frames. The table is copied. The device outlives the object. A
  // GpuError where memory cannot be had.
  GpuFrameGeneration(const GpuDevice& device, const FrameGenerationOptions& options,
                     PixelFormat format, const InputConventions& conventions = {});
  ~GpuFrameGeneration();

  // As those of FrameGeneration; they wait for the frame. A frame with an id (DisplayedFrame::id)
  // is uploaded and filtered once. A source that is shown as it is, is copied by the processor,
  // which also draws the HUD. A GpuError if the device fails, or at the first call if it does not
  // take a shader.
  //
  // The largest differences from FrameGeneration are those of tests/runtime/gpu.
  void Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out);
  void Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out);

  // Times of the passes of the last frame that was generated; empty where the device has no
  // timestamps.
  std::vector<PassTime> Times() const;
  // Bytes of all images and buffers.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
