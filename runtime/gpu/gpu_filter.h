// The filter of a warp as the shaders take it: its table as a texture, its numbers, its prefilter.
#pragma once

#include <vector>

#include "runtime/gpu/frame_numbers.h"
#include "runtime/gpu/gpu_workspace.h"
#include "runtime/warp.h"

namespace warplut {

// Adds the image of the table of the filter, one texel where it has none.
int AddTableImage(const WarpOptions& warp, GpuWorkspace& workspace);
// Its texels, of rgba32f; none where the filter has no table.
std::vector<float> TableTexels(const WarpOptions& warp);

// The number that FilterWeights needs beside the offset.
float FilterParameterOf(const WarpOptions& warp);

// constant_id 7 to 10 of shaders/formulas.glsl.
void AppendFilterConstants(const WarpOptions& warp, bool prefiltered,
                           std::vector<std::int32_t>* constants);

// The two passes that make coefficients of images of one size, columns first.
class PrefilterPasses {
 public:
  PrefilterPasses() = default;
  // The samples, the image between the passes, and the coefficients of each set.
  struct Images {
    int samples, columns, coefficients;
  };
  PrefilterPasses(const Prefilter& prefilter, int width, int height,
                  const std::vector<Images>& sets, GpuWorkspace& workspace);

  // Nothing where there is no prefilter.
  void Record(std::size_t set, GpuWorkspace& workspace) const;

 private:
  int columns_ = -1, rows_ = -1;
  PrefilterNumbers along_y_ = {}, along_x_ = {};
};

}  // namespace warplut
