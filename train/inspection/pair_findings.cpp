#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "train/inspection/findings.h"
#include "train/inspection/points.h"

namespace warplut {
namespace {

constexpr int kCell = 8;  // side of the cells that a HUD is looked for in, pixels

// The behaviour of a cell over the pairs: warped as its motion says, and left where it is.
struct Cell {
  int moving = 0;  // pairs in which it has motion and detail
  int stays = 0;   // those in which staying explains it far better
};

// A line through points, by least squares.
struct Line {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;

  void Add(double x, double y) {
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  // Nothing where too few points, or points too close to each other, tell one.
  std::optional<double> Slope() const {
    constexpr double kFewest = 200, kSpread = 0.004;
    const double xx = sxx - sx * sx / std::max(n, 1.0);
    if (n < kFewest || xx < kSpread * kSpread * n) return std::nullopt;
    return (sxy - sx * sy / n) / xx;
  }
};

class PairFaults {
 public:
  PairFaults(const Sequence& sequence, const MotionAnswer& motion, const JitterAnswer& jitter)
      : sequence_(sequence),
        motion_(motion),
        cycle_(JitterOf(sequence, jitter.found)),
        columns_((sequence.render.width + kCell - 1) / kCell),
        cells_(static_cast<std::size_t>(columns_) *
               static_cast<std::size_t>((sequence.render.height + kCell - 1) / kCell)) {
    jittered_motion_ = jitter.contains_jitter;
  }

  // `file`: the frame whose file has the motion of the pair.
  void Add(const InspectedFrame& earlier, const InspectedFrame& later, const InspectedFrame* file) {
    if (!later.Follows(earlier) || later.luma.empty() || earlier.luma.empty()) return;
    const bool forward = motion_.found.forward;
    const InspectedFrame& here = forward ? earlier : later;
    const InspectedFrame& there = forward ? later : earlier;
    Image motion(sequence_.render.width, sequence_.render.height, 2);
    if (file != nullptr && !file->motion.empty()) {
      motion = MotionInPixels(file->motion, motion_.found, sequence_.render, sequence_.output);
    }
    Compare(earlier, later, motion);
    const Vec2 from = JitterAt(cycle_, here.index), to = JitterAt(cycle_, there.index);
    Vec2 shift = {from.x - to.x, from.y - to.y};
    if (jittered_motion_) shift = {};
    const double sign = forward ? 1 : -1;
    AddErrors(here, there, motion, sign, shift, later.index);
    AddCells(here, there, motion, sign, shift);
    AddVignette(here, there, motion, sign, shift);
  }

  std::vector<Finding> Finish() const {
    std::vector<Finding> findings;
    AddCuts(&findings);
    if (!repeated_.empty()) {
      findings.push_back(
          {"repeated frame", Severity::kWarning,
           fmt::format("Frames {} are copies of the frame before, although motion or "
                       "jitter says that they differ.",
                       fmt::join(repeated_, ", "))});
    }
    AddHud(&findings);
    AddVignetteFinding(&findings);
    return findings;
  }

 private:
  void Compare(const InspectedFrame& earlier, const InspectedFrame& later, const Image& motion) {
    if (earlier.sharp_luma.data != later.sharp_luma.data) return;
    const Vec2 a = JitterAt(cycle_, earlier.index), b = JitterAt(cycle_, later.index);
    double longest = 0;
    ForPoints(sequence_.render, [&](int x, int y) {
      longest = std::max(longest, std::hypot(double{motion.at(x, y, 0)}, motion.at(x, y, 1)));
    });
    if (std::hypot(a.x - b.x, a.y - b.y) > 0.01 || longest > 0.5) {
      repeated_.push_back(sequence_.Number(later.index));
    }
  }

  // With its motion, and as unrelated parts of the same layout would do; after a change of exposure
  // or light, the brightness of the other frame counts as changed alike.
  void AddErrors(const InspectedFrame& here, const InspectedFrame& there, const Image& motion,
                 double sign, Vec2 shift, int index) {
    PairCost warped, unrelated;
    const GridSize grid = sequence_.render;
    double light_here = 0, light_there = 0;
    ForPoints(grid, [&](int x, int y) {
      light_here += here.luma.at(x, y);
      light_there += there.luma.at(x, y);
    });
    const float gain =
        light_here > 0 && light_there > 0 ? static_cast<float>(light_here / light_there) : 1.0F;
    ForPoints(grid, [&](int x, int y) {
      const float value = here.luma.at(x, y);
      const float w = BilinearAt(there.luma, x + sign * motion.at(x, y, 0) + shift.x,
                                 y + sign * motion.at(x, y, 1) + shift.y);
      if (!std::isnan(w)) warped.Add(x, y, grid, gain * w - value);
      for (const int part : {1, 2, 3}) {
        unrelated.Add(x, y, grid,
                      gain * there.luma.at((x + part * grid.width / 4) % grid.width, y) - value);
      }
    });
    errors_.push_back({index, warped.Mean(), unrelated.Mean()});
  }

  void AddCells(const InspectedFrame& here, const InspectedFrame& there, const Image& motion,
                double sign, Vec2 shift) {
    constexpr double kMoves = 0.5;
    constexpr double kDetail = 3.0 / 255;
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      const int x0 = static_cast<int>(cell) % columns_ * kCell;
      const int y0 = static_cast<int>(cell) / columns_ * kCell;
      const int x1 = std::min(x0 + kCell, sequence_.render.width);
      const int y1 = std::min(y0 + kCell, sequence_.render.height);
      double warped = 0, rest = 0, length = 0;
      int count = 0, outside = 0;
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          const double mx = motion.at(x, y, 0), my = motion.at(x, y, 1);
          const float w = BilinearAt(there.luma, x + sign * mx + shift.x, y + sign * my + shift.y);
          if (std::isnan(w)) ++outside;
          const double value = here.luma.at(x, y);
          warped += std::isnan(w) ? 0 : (w - value) * (w - value);
          const double r = there.luma.at(x, y) - value;
          rest += r * r;
          length += std::hypot(mx, my);
          ++count;
        }
      }
      if (outside > 0 || length < kMoves * count) continue;
      if (std::max(warped, rest) < kDetail * kDetail * count) continue;
      ++cells_[cell].moving;
      if (rest < warped / 9) ++cells_[cell].stays;
    }
  }

  // log(now / before) = slope (r^2 before - r^2 now) under a vignette; r is 1 in the corners.
  void AddVignette(const InspectedFrame& here, const InspectedFrame& there, const Image& motion,
                   double sign, Vec2 shift) {
    const double cx = sequence_.render.width / 2.0, cy = sequence_.render.height / 2.0;
    const double corner = cx * cx + cy * cy;
    const auto radius = [&](double x, double y) {
      return ((x + 0.5 - cx) * (x + 0.5 - cx) + (y + 0.5 - cy) * (y + 0.5 - cy)) / corner;
    };
    Line line;
    ForPoints(sequence_.render, [&](int x, int y) {
      const double at_x = x + sign * motion.at(x, y, 0) + shift.x;
      const double at_y = y + sign * motion.at(x, y, 1) + shift.y;
      const float before = BilinearAt(there.luma, at_x, at_y);
      const float now = here.luma.at(x, y);
      if (!(before > 0.06F) || !(now > 0.06F)) return;
      const double ratio = std::log(double{now} / before);
      if (std::abs(ratio) > 0.15) return;
      line.Add(radius(at_x, at_y) - radius(x, y), ratio);
    });
    if (const auto slope = line.Slope()) vignette_.push_back(*slope);
  }

  void AddCuts(std::vector<Finding>* findings) const {
    std::vector<double> ratios;
    for (const auto& error : errors_) {
      if (error.unrelated > 1e-6) ratios.push_back(error.warped / error.unrelated);
    }
    const double usual = Median(ratios);
    std::vector<int> cuts;
    constexpr double kUnrelated = 0.75, kUnusual = 1.3;
    for (const auto& error : errors_) {
      const bool flat = error.unrelated < 1e-4;
      if (flat || error.warped < kUnrelated * error.unrelated) continue;
      if (ratios.size() > 2 && error.warped < kUnusual * usual * error.unrelated) continue;
      cuts.push_back(sequence_.Number(error.index));
    }
    if (cuts.empty()) return;
    findings->push_back(
        {"unmarked cut", Severity::kWarning,
         fmt::format("No motion explains frame{} {}: expected a cut there. Add \"cuts\": [{}].",
                     cuts.size() > 1 ? "s" : "", fmt::join(cuts, ", "), fmt::join(cuts, ", "))});
  }

  void AddHud(std::vector<Finding>* findings) const {
    int found = 0, x0 = columns_, y0 = 1 << 30, x1 = 0, y1 = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i].moving < 3 || cells_[i].stays * 10 < cells_[i].moving * 9) continue;
      const int x = static_cast<int>(i) % columns_, y = static_cast<int>(i) / columns_;
      ++found;
      x0 = std::min(x0, x);
      x1 = std::max(x1, x + 1);
      y0 = std::min(y0, y);
      y1 = std::max(y1, y + 1);
    }
    // A few cells may agree by chance: things that move along themselves.
    const auto least = std::max(6, static_cast<int>(cells_.size() / 500));
    if (found < least) return;
    findings->push_back(
        {"HUD", Severity::kWarning,
         fmt::format("{:.1f} % of the image stays on the screen although its motion says that it "
                     "moves (a HUD?), within pixels ({}, {}) to ({}, {}). Its motion should be 0.",
                     100.0 * found / static_cast<double>(cells_.size()), x0 * kCell, y0 * kCell,
                     std::min(x1 * kCell, sequence_.render.width) - 1,
                     std::min(y1 * kCell, sequence_.render.height) - 1)});
  }

  void AddVignetteFinding(std::vector<Finding>* findings) const {
    const PairedDifference slope = Difference(vignette_, SampleScores(vignette_.size(), 0));
    // A surface that nears the camera through haze changes its brightness too, up to half as fast.
    constexpr double kLeastSlope = 0.3;
    if (vignette_.size() < 3 || !slope.IsTold(kLeastSlope)) return;
    findings->push_back(
        {"vignette", Severity::kWarning,
         "The image is darker towards its corners, and the darkening stays on the screen (a "
         "vignette). Render without it, or add it after super resolution."});
  }

  struct Errors {
    int index;
    double warped, unrelated;
  };
  const Sequence& sequence_;
  const MotionAnswer& motion_;
  std::vector<Vec2> cycle_;
  bool jittered_motion_ = false;
  int columns_;
  std::vector<Cell> cells_;
  std::vector<Errors> errors_;
  std::vector<int> repeated_;
  SampleScores vignette_;
};

}  // namespace

std::vector<Finding> FindPairFaults(const Sequence& sequence, const InspectedClip& clip,
                                    const MotionAnswer& motion, const JitterAnswer& jitter,
                                    const std::function<void()>& on_pair) {
  PairFaults faults(sequence, motion, jitter);
  InspectedWindow window(sequence, clip);
  for (int index = 1; index < sequence.count; ++index) {
    const int file = (motion.found.forward ? index - 1 : index) + motion.found.frame_offset;
    faults.Add(window.At(index - 1), window.At(index),
               file >= 0 && file < sequence.count ? &window.At(file) : nullptr);
    on_pair();
  }
  return faults.Finish();
}

}  // namespace warplut
