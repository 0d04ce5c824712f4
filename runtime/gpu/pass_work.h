// The work of the passes of super resolution and frame generation on a GPU, and the least time that
// takes.
#pragma once

#include <string>
#include <vector>

#include "runtime/frame_generation.h"
#include "runtime/super_resolution.h"

namespace warplut {

// One pass, per pixel of its grid: texels fetched, floating-point operations (a fused one counts
// as two) of an inner pixel with history, and bytes that must come from memory or go there: each
// image once, as caches catch its neighbours.
struct PassWork {
  std::string pass;
  double pixels = 0;
  double fetches = 0, operations = 0, bytes = 0;
};

// Bytes of a texel of what the renderer hands over: the inputs as engines have them.
struct InputBytes {
  int color = 4;   // R11G11B10F
  int depth = 4;   // D32F
  int motion = 4;  // RG16F
};

// The passes of a frame in their order, with a history in RGBA16F. Counts follow
// runtime/gpu/shaders by hand; tools/measure/count_shader_work.sh compares them with the SPIR-V.
// The options have the default form, clamp, depth measure and motion.
std::vector<PassWork> WorkOf(const SuperResolutionOptions& options, const InputBytes& inputs = {});

// Those of one generated frame, of which frame 1 is new. The options have display values, splatting
// and the default choices.
std::vector<PassWork> WorkOf(const FrameGenerationOptions& options, bool interpolates,
                             const InputBytes& inputs = {});

// One warp by Catmull-Rom in 9 fetches that filter, for comparison.
PassWork NineTapWarp(const SuperResolutionOptions& options);

// The larger of the times that memory and arithmetic need.
double RooflineMilliseconds(const PassWork& work, double bytes_per_second,
                            double operations_per_second);

}  // namespace warplut
