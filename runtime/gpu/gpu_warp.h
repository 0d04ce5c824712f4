// A warp alone on a GPU: runtime/warp.h as a compute shader, and Catmull-Rom in fewer fetches to
// compare with.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/gpu/gpu_workspace.h"
#include "runtime/warp.h"

namespace warplut {

struct GpuWarpOptions {
  int width = 0, height = 0;                   // each in [1, 16384]
  PixelFormat format = PixelFormat::kRgba16F;  // of all images; or kRgba32F
  WarpOptions warp;
  // 16: every tap is fetched. Filter::kCatmullRom in kRgba16F also takes 9 or 5, as samplers filter
  // halves on every device; with 5 the corners are left out and the rest weighs more.
  int fetches = 16;

  // Whether the options can be used; otherwise *why (if not null) says why not.
  bool IsValid(std::string* why = nullptr) const;
};

class GpuWarp {
 public:
  // Valid options. The table is copied. The device outlives the object. A GpuError where memory or
  // a shader cannot be had.
  GpuWarp(const GpuDevice& device, const GpuWarpOptions& options);
  ~GpuWarp();

  // out(p) = image(p - motion(p)), as Warp, and waits for it. All have the size of the options;
  // colours may have any format of RenderedFrame. A filter with prefilter has it run first. A
  // GpuError if the device fails.
  //
  // The largest differences from WarpReference are those of tests/runtime/gpu. With 9 fetches the
  // sampler rounds the place of a fetch, often to 1 / 256 of a texel.
  void Apply(const ImageView& image, const MotionView& motion, const MutableImageView& out);

  // Times of the passes of the last Apply; empty where the device has none.
  std::vector<PassTime> Times() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
