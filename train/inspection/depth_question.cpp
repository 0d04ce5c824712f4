#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/camera_motion.h"
#include "runtime/image_buffer.h"
#include "train/inspection/points.h"
#include "train/inspection/questions.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

// The distance from the 5 % to the 95 % quantile of depth that is finite.
float Spread(const Image& depth, GridSize grid) {
  std::vector<float> values;
  ForPoints(grid, [&](int x, int y) {
    const float z = depth.at(x, y);
    if (std::isfinite(z)) values.push_back(z);
  });
  if (values.size() < 20) return 0;
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 20);
  const auto high = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 19 / 20);
  std::nth_element(values.begin(), low, values.end());
  const float least = *low;
  std::nth_element(values.begin(), high, values.end());
  return *high - least;
}

std::array<float, 2> LeastAndGreatest(const Image& image, int x, int y) {
  std::array<float, 2> range = {image.at(x, y), image.at(x, y)};
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      range[0] = std::min(range[0], image.at(x + dx, y + dy));
      range[1] = std::max(range[1], image.at(x + dx, y + dy));
    }
  }
  return range;
}

// Shares, in dB, of the pixels that were covered by something of smaller and of larger depth.
void AddUncovered(const Image& before, const Image& now, const Image& motion, bool forward,
                  GridSize grid, SampleScores* farther, SampleScores* nearer) {
  const Image& at = forward ? before : now;
  const Image& other = forward ? now : before;
  const float least = 0.05F * Spread(at, grid);
  double smaller = 0, larger = 0;
  for (int y = 0; y < grid.height && least > 0; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const float mx = motion.at(x, y, 0), my = motion.at(x, y, 1);
      const int i = x + static_cast<int>(std::lround(forward ? mx : -mx));
      const int j = y + static_cast<int>(std::lround(forward ? my : -my));
      if (i < 1 || j < 1 || i + 1 >= grid.width || j + 1 >= grid.height) continue;
      if (x < 1 || y < 1 || x + 1 >= grid.width || y + 1 >= grid.height) continue;
      // 3 x 3 pixels against 3 x 3: edges a pixel off and things a pixel thin do not count.
      const auto here = LeastAndGreatest(at, x, y), there = LeastAndGreatest(other, i, j);
      smaller += there[1] < here[0] - least ? 1 : 0;
      larger += there[0] > here[1] + least ? 1 : 0;
    }
  }
  constexpr double kFewest = 12;
  const bool enough = smaller + larger >= kFewest;
  const double all = smaller + larger + 2;
  // Uncovered pixels were covered by what is nearer, so by smaller depth where farther is larger.
  farther->push_back(enough ? 10 * std::log10((smaller + 1) / all) : std::nan(""));
  nearer->push_back(enough ? 10 * std::log10((larger + 1) / all) : std::nan(""));
}

// How far from affine g(z) is on the image, in dB: the quantile of |second| / |first difference|
// over rows and columns; for g = 1 / z and g = z.
void AddPlanes(const Image& depth, GridSize grid, SampleScores* inverse, SampleScores* itself) {
  const int step = std::max(2, grid.width / 100);
  const float least = 1e-5F * Spread(depth, grid);
  std::vector<double> of_inverse, of_itself;
  const auto add = [&](float a, float b, float c) {
    if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c)) return;
    if (!(a > 0 && b > 0 && c > 0) || !(std::abs(a - c) > least)) return;
    const auto bend = [](double p, double q, double r) {
      return std::abs(p - 2 * q + r) / std::abs(p - r);
    };
    of_itself.push_back(bend(a, b, c));
    of_inverse.push_back(bend(1.0 / a, 1.0 / b, 1.0 / c));
  };
  ForPoints(grid, [&](int x, int y) {
    if (x < step || y < step || x + step >= grid.width || y + step >= grid.height) return;
    add(depth.at(x - step, y), depth.at(x, y), depth.at(x + step, y));
    add(depth.at(x, y - step), depth.at(x, y), depth.at(x, y + step));
  });
  constexpr std::size_t kFewest = 200;
  if (of_itself.size() < kFewest) {
    inverse->push_back(std::nan(""));
    itself->push_back(std::nan(""));
    return;
  }
  constexpr double kFloor = 1e-5;
  const auto quantile = [](std::vector<double>& bends) {
    const auto at = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() * 3 / 10);
    std::nth_element(bends.begin(), at, bends.end());
    return -20 * std::log10(*at + kFloor);
  };
  inverse->push_back(quantile(of_inverse));
  itself->push_back(quantile(of_itself));
}

// How well a camera explains the motion if the inverse depth is 1 / z, or affine in z.
void AddParallax(const Image& depth, const Image& motion, bool nearer_is_larger,
                 SampleScores* inverse, SampleScores* itself) {
  Image affine = depth;
  float largest = 0;
  for (const float z : depth.data) {
    if (std::isfinite(z)) largest = std::max(largest, z);
  }
  for (float& z : affine.data) {
    const float g = nearer_is_larger ? z : largest - z;
    z = std::isfinite(g) && g > 0 ? 1 / g : std::numeric_limits<float>::infinity();
  }
  const MotionBuffer vectors = ToMotionBuffer(motion);
  const auto score = [&](const Image& image) {
    CameraFit fit(image.width, image.height);
    const CameraMotion camera = fit.Fit(ToBuffer(image, PixelFormat::kR32F).view(), vectors.view());
    return -20 * std::log10(std::hypot(camera.noise_x, camera.noise_y) + 1e-4);
  };
  inverse->push_back(score(depth));
  itself->push_back(score(affine));
}

// A depth buffer, 0 to 1, has nearly all of its values on the side of the far plane: what is at 1/2
// is twice as far as the near plane.
void OrderByValues(const InspectedClip& clip, DepthAnswer* answer) {
  std::size_t low = 0, high = 0;
  for (const InspectedFrame& frame : clip.frames) {
    for (const float z : frame.depth.data) {
      if (!(z >= 0 && z <= 1)) return;
      ++(z < 0.5F ? low : high);
    }
  }
  constexpr std::size_t kMost = 9;  // times as many
  if (low < kMost * high && high < kMost * low) return;
  const std::string found = DepthConvention{low > high, true}.OrderName();
  answer->order.reason.clear();
  answer->order.found = found;
  answer->order.verdict = found == answer->order.stated ? Verdict::kAgrees : Verdict::kContradicts;
  answer->order.candidates = {{found, 0, 0, 0, found == answer->order.stated}};
}

Ranking RankTwo(const std::string& question, const std::string& first, const std::string& second,
                const SampleScores& of_first, const SampleScores& of_second,
                const std::string& stated, double least) {
  Ranking ranking = RankValues(question, {first, second}, {of_first, of_second}, stated, least);
  if (ranking.candidates.size() < 2 && ranking.reason.empty()) ranking.reason = "no evidence";
  return ranking;
}

}  // namespace

DepthAnswer AskDepth(const Sequence& sequence, const InspectedClip& clip,
                     const MotionConvention& convention) {
  DepthAnswer answer;
  answer.found = StatedDepth(*sequence.depth);
  SampleScores farther, nearer, plane_inverse, plane_itself, parallax_inverse, parallax_itself;
  std::vector<Image> motions(clip.frames.size());
  for (std::size_t i = 0; i < clip.frames.size(); ++i) {
    const InspectedFrame& frame = clip.frames[i];
    if (!frame.depth.empty()) AddPlanes(frame.depth, clip.render, &plane_inverse, &plane_itself);
    if (!frame.motion.empty()) {
      motions[i] = MotionInPixels(frame.motion, convention, clip.render, clip.output);
    }
  }
  for (const FramePair& pair : UsablePairs(clip)) {
    const std::size_t frame = convention.forward ? pair.earlier : pair.later;
    const auto file = static_cast<std::ptrdiff_t>(frame) + convention.frame_offset;
    if (file < 0 || file >= static_cast<std::ptrdiff_t>(clip.frames.size())) continue;
    const Image& motion = motions[static_cast<std::size_t>(file)];
    const Image& before = clip.frames[pair.earlier].depth;
    const Image& now = clip.frames[pair.later].depth;
    if (motion.empty() || before.empty() || now.empty()) continue;
    AddUncovered(before, now, motion, convention.forward, clip.render, &farther, &nearer);
  }
  const std::string nearer_name = DepthConvention{true, false}.OrderName();
  // Shares of pixels move by chance: half a dB is none.
  constexpr double kLeastOrder = 0.5;
  answer.order = RankTwo("depth order", DepthConvention{false, false}.OrderName(),
                         DepthConvention{true, false}.OrderName(), farther, nearer,
                         answer.found.OrderName(), kLeastOrder);
  if (answer.order.verdict == Verdict::kCannotTell && answer.order.reason.empty()) {
    answer.order.reason = "too little is uncovered from frame to frame";
  }
  const std::string inverse_name = DepthConvention{false, false}.CurveName();
  const std::string itself_name = DepthConvention{false, true}.CurveName();
  const std::string stated = answer.found.CurveName();
  constexpr double kLeastCurve = 3;
  answer.curve = RankTwo("depth is linear", inverse_name, itself_name, plane_inverse, plane_itself,
                         stated, kLeastCurve);
  answer.curve_evidence = "planes";
  if (answer.curve.verdict == Verdict::kCannotTell && convention.frame_offset == 0) {
    for (const FramePair& pair : UsablePairs(clip)) {
      const std::size_t frame = convention.forward ? pair.earlier : pair.later;
      const Image& depth = clip.frames[frame].depth;
      if (depth.empty() || motions[frame].empty()) continue;
      AddParallax(depth, motions[frame], answer.order.found == nearer_name, &parallax_inverse,
                  &parallax_itself);
    }
    Ranking parallax = RankTwo("depth is linear", inverse_name, itself_name, parallax_inverse,
                               parallax_itself, stated, kLeastCurve);
    if (parallax.verdict != Verdict::kCannotTell) {
      answer.curve = std::move(parallax);
      answer.curve_evidence = "parallax";
    } else {
      answer.curve.reason = "neither planes nor parallax are clear enough";
    }
  }
  if (answer.curve.verdict == Verdict::kContradicts) {
    answer.found.hyperbolic = !answer.found.hyperbolic;
  }
  if (answer.order.verdict == Verdict::kCannotTell && answer.found.hyperbolic) {
    OrderByValues(clip, &answer);
  }
  if (answer.order.verdict == Verdict::kContradicts) {
    answer.found.nearer_is_larger = !answer.found.nearer_is_larger;
  }
  return answer;
}

}  // namespace warplut
