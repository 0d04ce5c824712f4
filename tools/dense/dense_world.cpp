#include "tools/dense/dense_world.h"

#include <cmath>
#include <memory>

namespace warplut {
namespace {

// Scenes with cuts spread their takes over the frames: of so many times as many, the first take
// holds those that are judged.
constexpr int kTakes = 8;

RenderOptions Renderer(const DenseWorldOptions& options, double rate, int frames) {
  RenderOptions render;
  render.width = options.width;
  render.height = options.height;
  render.scale = 1;
  render.frames = frames * kTakes;
  render.rate = rate / options.speed;
  render.samples = options.samples;
  render.seed = options.seed;
  render.inputs = false;
  return render;
}

// The pattern at rest. Periods are no whole pixels, so that every phase of an edge occurs.
std::array<float, 3> PatternAt(double x, double y) {
  const double shade = 0.35 + 0.1 * std::sin(0.05 * x) * std::cos(0.043 * y);
  std::array<float, 3> color = {static_cast<float>(shade), static_cast<float>(0.9 * shade),
                                static_cast<float>(1.1 * shade)};
  constexpr double kPeriod = 23.3, kRadius = 7.2, kThin = 1.3;
  const double u = 0.96 * x + 0.28 * y, v = 0.96 * y - 0.28 * x;
  const double cell_u = u - kPeriod * std::floor(u / kPeriod) - kPeriod / 2;
  const double cell_v = v - kPeriod * std::floor(v / kPeriod) - kPeriod / 2;
  const auto cell = static_cast<int>(std::floor(u / kPeriod) + 2 * std::floor(v / kPeriod));
  const bool is_disc = cell % 3 != 0;
  const bool inside = is_disc ? std::hypot(cell_u, cell_v) < kRadius
                              : std::abs(cell_u - 0.4 * cell_v * (cell % 2 == 0 ? 1 : -1)) < kThin;
  if (inside) color = {0.95f, is_disc ? 0.9f : 0.6f, is_disc ? 0.8f : 0.1f};
  return color;
}

struct Pattern {
  double x, y;  // pixels per subframe
  DenseWorldOptions options;

  std::vector<SceneSample> Trace(int index, std::span<const Vec2> positions, int step) const {
    std::vector<SceneSample> samples;
    samples.reserve(positions.size());
    for (const Vec2& p : positions) {
      samples.push_back({PatternAt(p.x - index * x, p.y - index * y),
                         0.5f,
                         {static_cast<float>(step * x), static_cast<float>(step * y)}});
    }
    return samples;
  }

  // Means over a square grid of samples in each pixel.
  Frame Reference(int index) const {
    Frame frame;
    frame.number = index;
    frame.reference = Image(options.width, options.height, 3);
    frame.reference_depth = Image(options.width, options.height, 1);
    frame.reference_motion = Image(options.width, options.height, 2);
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(options.samples))));
    for (int j = 0; j < options.height; ++j) {
      for (int i = 0; i < options.width; ++i) {
        std::array<double, 3> sum{};
        for (int s = 0; s < side * side; ++s) {
          const double px = i + (s % side + 0.5) / side, py = j + (s / side + 0.5) / side;
          const auto color = PatternAt(px - index * x, py - index * y);
          for (int c = 0; c < 3; ++c) sum[c] += color[c];
        }
        for (int c = 0; c < 3; ++c) {
          frame.reference.at(i, j, c) = static_cast<float>(sum[c] / (side * side));
        }
        frame.reference_depth.at(i, j) = 0.5f;
        frame.reference_motion.at(i, j, 0) = static_cast<float>(x);
        frame.reference_motion.at(i, j, 1) = static_cast<float>(y);
      }
    }
    return frame;
  }
};

}  // namespace

DenseWorld SceneWorld(const std::string& scene, const DenseWorldOptions& options, int subframes) {
  const auto fast =
      std::make_shared<const SceneRenderer>(scene, Renderer(options, kDenseRate, subframes));
  const auto slow = std::make_shared<const SceneRenderer>(
      scene, Renderer(options, kDenseRate / kSlowStep, subframes));
  return {
      options.width, options.height,
      [fast](int index, std::span<const Vec2> at) { return fast->Trace(index, at); },
      [slow](int index, std::span<const Vec2> at) { return slow->Trace(index / kSlowStep, at); },
      [fast](int index) { return fast->Render(index); }};
}

DenseWorld PatternWorld(double x, double y, const DenseWorldOptions& options) {
  const Pattern pattern{x, y, options};
  return {options.width, options.height,
          [pattern](int index, std::span<const Vec2> at) { return pattern.Trace(index, at, 1); },
          [pattern](int index, std::span<const Vec2> at) {
            return pattern.Trace(index, at, kSlowStep);
          },
          [pattern](int index) { return pattern.Reference(index); }};
}

}  // namespace warplut
