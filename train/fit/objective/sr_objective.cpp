#include "train/fit/objective/sr_objective.h"

#include <algorithm>
#include <cmath>

#include "datasets/jitter.h"
#include "luts/filters.h"
#include "train/fit/random.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rivals/rivals.h"
#include "train/fit/rollout/band_limited.h"

namespace warplut {
namespace {

constexpr double kMeanPower = 1;

std::vector<Protocol> SrProtocols(const std::vector<int>& horizons, bool with_pan) {
  std::vector<Protocol> protocols;
  protocols.reserve(horizons.size() + 1);
  for (const int warps : horizons) protocols.push_back({warps, Offsets::kRandom});
  if (with_pan) protocols.push_back({kNodes, Offsets::kPan});
  return protocols;
}

float Bilinear(const BorderedPlane& plane, double x, double y) {
  x = std::clamp(x - 0.5, 0.0, plane.width() - 1.001);
  y = std::clamp(y - 0.5, 0.0, plane.height() - 1.001);
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  const auto across = [&](const float* row) {
    return std::lerp(row[left], row[left + 1], static_cast<float>(x - left));
  };
  return std::lerp(across(plane.row(top)), across(plane.row(top + 1)), static_cast<float>(y - top));
}

// What the samples of `grid` see of the scene after it has moved by `moved`.
FrameSamples TakeSamples(const SampleGrid& grid, const BorderedPlane& scene,
                         const Displacement& moved, double aliasing, Random& random) {
  std::vector<double> xs, ys;
  for (int i = 0; i < grid.columns(); ++i) xs.push_back(grid.PositionX(i) - moved.x);
  for (int j = 0; j < grid.rows(); ++j) ys.push_back(grid.PositionY(j) - moved.y);
  FrameSamples frame{&grid, std::vector<float>(xs.size() * ys.size())};
  SampleBandLimited(scene, xs, ys, frame.values);
  if (!(aliasing > 0)) return frame;
  float* value = frame.values.data();
  for (const double y : ys) {
    for (const double x : xs) {
      const double dx = aliasing * random.Normal();
      const double dy = aliasing * random.Normal();
      *value++ += (Bilinear(scene, x + dx, y + dy) - Bilinear(scene, x - dx, y - dy)) / 2;
    }
  }
  return frame;
}

}  // namespace

SrObjective::SrObjective(std::vector<BorderedPlane> all_crops, const std::vector<int>& horizons,
                         std::uint64_t seed, const SrObjectiveOptions& options,
                         const Objective* like)
    : Objective(std::move(all_crops), SrProtocols(horizons, options.pans_per_crop > 0),
                {{0, horizons.size(), 1 - options.pan_share},
                 {horizons.size(), options.pans_per_crop > 0 ? 1u : 0u, options.pan_share}},
                kMeanPower) {
  const SampleGridOptions grid_options{crops()[0].width(), crops()[0].height(), options.scale,
                                       options.blend_a, options.blend_b};
  for (const Vec2& jitter : JitterCycle(options.scale)) grids_.emplace_back(grid_options, jitter);
  const int phases = static_cast<int>(grids_.size());
  const std::size_t count = horizons.size();
  std::uint64_t drawn = 0;
  const auto add = [&](std::size_t crop, std::size_t first, std::size_t protocols_judged) {
    const std::uint64_t rollout_seed = DeriveSeed(seed, drawn++);
    const auto trajectory = DrawTrajectory(first, protocols_judged, rollout_seed);
    const int phase = Random(DeriveSeed(rollout_seed, 1)).Below(phases);
    AddSamples(crops()[crop], phase, trajectory, options.aliasing, DeriveSeed(rollout_seed, 2),
               AddRollout(crop, first, protocols_judged, trajectory));
  };
  for (std::size_t c = 0; c < crops().size(); ++c) {
    add(c, 0, count);
    for (int i = 0; i < options.pans_per_crop; ++i) add(c, count, 1);
  }
  if (like != nullptr) {
    ScaleBaselines(*like);
  } else {
    const std::vector<Rival> rivals = JudgeRivals(*this, options.rivals);
    SetBaselines(LeastLosses(rivals), options.rivals.HasKeys()
                                          ? KeysCanonicalWeights(kCatmullRomA)
                                          : BestRival(rivals, count - 1).resampler);
  }
}

void SrObjective::AddSamples(const BorderedPlane& crop, std::size_t first_phase,
                             const std::vector<Displacement>& trajectory, double aliasing,
                             std::uint64_t seed, Rollout& rollout) {
  Random random(seed);
  Displacement moved;
  const FrameSamples first = TakeSamples(grids_[first_phase], crop, moved, aliasing, random);
  BorderedPlane& start = starts_.emplace_back(crop.width(), crop.height());
  first.grid->Interpolate(first.values, start);
  FillBorder(start);
  rollout.start = &start;
  for (std::size_t t = 0; t < trajectory.size(); ++t) {
    moved.x += trajectory[t].x;
    moved.y += trajectory[t].y;
    const SampleGrid& grid = grids_[(first_phase + t + 1) % grids_.size()];
    rollout.frames.push_back(TakeSamples(grid, crop, moved, aliasing, random));
  }
}

}  // namespace warplut
