// What temporally dense rendering is judged on: something that can be sampled anywhere at any
// subframe, with its ideal frames.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "datasets/scenes/scene_renderer.h"

namespace warplut {

// Subframes per second, and those that the frames of a slow display are apart.
inline constexpr double kDenseRate = 240;
inline constexpr int kSlowStep = 4;

struct DenseWorld {
  int width = 0, height = 0;
  // Samples of subframe `index` at positions in pixels; motion from the subframe before.
  std::function<std::vector<SceneSample>(int index, std::span<const Vec2> positions)> trace;
  // The same with motion since kSlowStep subframes before; `index` is one of their multiples.
  std::function<std::vector<SceneSample>(int index, std::span<const Vec2> positions)> trace_slow;
  // The ideal frame: reference, reference_depth, reference_motion.
  std::function<Frame(int index)> reference;
};

struct DenseWorldOptions {
  int width = 320, height = 180;
  int samples = 64;  // per pixel of the reference
  // Of the clock of scenes, in (0, 60]: 6 at 320 x 180 has about the motion in pixels of 1080p.
  double speed = 1;
  std::uint64_t seed = 1;
};

// A built-in scene, which has no cut in the first `subframes`.
DenseWorld SceneWorld(const std::string& scene, const DenseWorldOptions& options, int subframes);

// Discs and bars before a soft ground, which move by (x, y) pixels per subframe; depth is constant.
DenseWorld PatternWorld(double x, double y, const DenseWorldOptions& options);

}  // namespace warplut
