// Samplers for PlainWarp: each returns the value at texel (x, y) + (dx, dy).
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "luts/filters.h"
#include "luts/fit/head.h"
#include "luts/quantize/real_table.h"
#include "luts/table.h"
#include "tools/judge/images/plain_warp.h"
#include "tools/judge/images/six_taps.h"

namespace warplut {

struct NearestSampler {
  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) const {
    return history.At(x + (dx >= 0.5f ? 1 : 0), y + (dy >= 0.5f ? 1 : 0));
  }
};

// One bilinear fetch, as a texture unit makes it; with d anywhere: it moves to the cell that
// contains the position.
inline PlainTexel BilinearFetch(const PlainHistory& history, int x, int y, float dx, float dy) {
  const int whole_x = static_cast<int>(std::floor(dx)), whole_y = static_cast<int>(std::floor(dy));
  x += whole_x;
  y += whole_y;
  dx -= static_cast<float>(whole_x);
  dy -= static_cast<float>(whole_y);
  PlainTexel sum;
  sum.Add((1 - dx) * (1 - dy), history.At(x, y)).Add(dx * (1 - dy), history.At(x + 1, y));
  return sum.Add((1 - dx) * dy, history.At(x, y + 1)).Add(dx * dy, history.At(x + 1, y + 1));
}

struct BilinearSampler {
  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) const {
    return BilinearFetch(history, x, y, dx, dy);
  }
};

// The weights of a footprint's taps.
inline PlainTexel SumTaps(Footprint footprint, const PlainHistory& history, int x, int y,
                          const Weights<float>& weights) {
  PlainTexel sum;
  for (const int k : TapsOf(footprint)) {
    sum.Add(weights[k], history.At(x + TapX(k), y + TapY(k)));
  }
  return sum;
}

struct CatmullRomSampler {
  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) const {
    return SumTaps(Footprint::k16, history, x, y,
                   KeysWeights(static_cast<float>(kCatmullRomA), dx, dy));
  }
};

// Catmull-Rom by bilinear fetches: the two inner taps of an axis, whose weights have one sign, are
// one fetch between them. With 3 x 3 fetches it equals the 16 taps. With 5 the corners, whose
// weights are small, are left out and the rest is divided by its sum (Jimenez 2016).
template <bool kCorners>
struct FetchedCatmullRomSampler {
  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) const {
    const Axis ax(dx), ay(dy);
    PlainTexel sum;
    float total = 0;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        if (!kCorners && i != 1 && j != 1) continue;
        const float weight = ax.weight[i] * ay.weight[j];
        sum.Add(weight, BilinearFetch(history, x, y, ax.place[i], ay.place[j]));
        total += weight;
      }
    }
    if constexpr (!kCorners) {
      for (float& value : sum.c) value /= total;
    }
    return sum;
  }

 private:
  struct Axis {
    explicit Axis(float d) {
      const auto taps = KeysTaps(static_cast<float>(kCatmullRomA), d);
      weight = {taps[0], taps[1] + taps[2], taps[3]};
      place = {-1, taps[2] / weight[1], 2};
    }
    std::array<float, 3> weight, place;
  };
};

// sinc(t) sinc(t / 3) on 6 x 6 taps.
struct LanczosSampler {
  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) const {
    return Sum36(history, x, y, LanczosTaps(dx), LanczosTaps(dy));
  }
};

// A table of any number of nodes per axis.
class PlainTable {
 public:
  // Both ends of the offsets have a node, as in RealTable.
  PlainTable(int intervals, Footprint footprint, std::vector<Weights<float>> rows)
      : intervals_(intervals), footprint_(footprint), rows_(std::move(rows)) {}

  int intervals() const { return intervals_; }
  Footprint footprint() const { return footprint_; }
  const Weights<float>& Row(int ix, int jy) const {
    return rows_[static_cast<std::size_t>(jy) * static_cast<std::size_t>(intervals_ + 1) +
                 static_cast<std::size_t>(ix)];
  }

 private:
  int intervals_;
  Footprint footprint_;
  std::vector<Weights<float>> rows_;
};

template <Lookup kLookup>
struct TableSampler {
  const PlainTable* table;

  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) const {
    const auto n = static_cast<float>(table->intervals());
    const float px = dx * n, py = dy * n;
    if constexpr (kLookup == Lookup::kNearest) {
      return SumTaps(table->footprint(), history, x, y,
                     table->Row(static_cast<int>(px + 0.5f), static_cast<int>(py + 0.5f)));
    } else {
      const int ix = static_cast<int>(px), jy = static_cast<int>(py);
      const float fx = px - static_cast<float>(ix), fy = py - static_cast<float>(jy);
      const auto &a = table->Row(ix, jy), &b = table->Row(ix + 1, jy), &c = table->Row(ix, jy + 1),
                 &d = table->Row(ix + 1, jy + 1);
      Weights<float> weights{};
      for (const int k : TapsOf(table->footprint())) {
        const float above = a[k] + fx * (b[k] - a[k]), below = c[k] + fx * (d[k] - c[k]);
        weights[k] = above + fy * (below - above);
      }
      return SumTaps(table->footprint(), history, x, y, weights);
    }
  }
};

// The MLP of a fit at the very offset, through the head and all 8 symmetries. The weights of the
// pixel before are taken again where the offset is the same.
class MlpSampler {
 public:
  explicit MlpSampler(const std::vector<float>* parameters, Footprint footprint, double kaiser_b)
      : parameters_(parameters), footprint_(footprint), kaiser_b_(kaiser_b) {}

  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) {
    if (!known_ || dx != dx_ || dy != dy_) {
      const float* parameters = parameters_->data();
      weights_ = footprint_ == Footprint::k16
                     ? HeadWeights(parameters, dx, dy)
                     : HeadWeights(footprint_, kaiser_b_, parameters, static_cast<double>(dx),
                                   static_cast<double>(dy));
      dx_ = dx;
      dy_ = dy;
      known_ = true;
    }
    return SumTaps(footprint_, history, x, y, weights_);
  }

 private:
  const std::vector<float>* parameters_;
  Footprint footprint_;
  double kaiser_b_;
  bool known_ = false;
  float dx_ = 0, dy_ = 0;
  Weights<float> weights_{};
};

}  // namespace warplut
