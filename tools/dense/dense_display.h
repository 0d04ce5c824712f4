// What a display shows at 240 Hz: frames rendered in one of several ways from samples of a world.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/dense_rendering.h"
#include "tools/dense/dense_world.h"

namespace warplut {

// kOneSample: one sample at each pixel's centre. kTaa: method taau without upscaling, jittered.
// kDense: DenseRendering.
enum class DenseShading : std::uint8_t { kOneSample, kTaa, kDense };

struct DenseDisplay {
  std::string name;
  DenseShading shading = DenseShading::kOneSample;
  int held = 1;        // subframes that each rendered frame is shown for: 1, or kSlowStep at 60 Hz
  DenseOptions dense;  // of kDense; the size is that of the world

  // Samples that are traced per pixel in kSlowStep subframes.
  int SamplesPerPixel() const { return shading == DenseShading::kDense ? 1 : kSlowStep / held; }
};

// Those that are compared: one sample and TAA at 60 Hz; the hourglass, the bowtie and the adaptive
// order of `dense` at 240 Hz; the last without reprojection; one sample at 240 Hz.
std::vector<DenseDisplay> ComparedDisplays(const DenseOptions& dense);

// The frames shown in subframes 0 to `subframes` - 1. A frame that is held was rendered for the
// first of its subframes.
std::vector<Image> ShownFrames(const DenseWorld& world, const DenseDisplay& display, int subframes);

}  // namespace warplut
