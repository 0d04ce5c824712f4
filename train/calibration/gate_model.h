// A pipeline in small: pixels with a gate, a blend and a clamp whose best parameters are known in
// advance.
#pragma once

#include <cmath>
#include <vector>

#include "runtime/gates.h"
#include "train/calibration/residual_function.h"
#include "train/fit/random.h"

namespace warplut {

// Tiles of pixels. A pixel's history is right or wrong; wrong ones differ more in depth. Taking a
// wrong history costs, and so does rejecting a right one; the blend's share a (1 - b / 2) and the
// slope b have their own best values. Every tile has a loss of its own that no parameter takes
// away, as images have, and tiles differ in what suits them.
class GateModel final : public ResidualFunction {
 public:
  struct Truth {
    double threshold = 0.05;  // between right and wrong history
    double share = 0.4;
    double slope = 1.5;
    double floor = 0.05;  // of every tile's loss
    double spread = 0.2;  // how much tiles differ
    bool threshold_acts = true;
    double scale = 1;  // of everything that parameters act on
  };

  explicit GateModel(const Truth& truth, int tiles = 64, int pixels = 400)
      : truth_(truth), tiles_(tiles) {
    Random random(7);
    for (int t = 0; t < tiles; ++t) {
      Tile tile{.shift = truth.spread * random.Normal(),
                .turn = truth.spread * random.Normal(),
                .floor = truth.floor * (0.5 + random.Uniform()),
                .pixels = {}};
      for (int p = 0; p < pixels; ++p) {
        const bool wrong = random.Uniform() < 0.3;
        const double away = std::abs(random.Normal()) + 0.05;
        tile.pixels.push_back(
            {static_cast<float>(truth.threshold * std::exp(wrong ? away : -away)), wrong});
      }
      tiles_of_.push_back(std::move(tile));
    }
  }

  std::size_t Size() const override { return tiles_of_.size(); }
  int runs() const { return runs_; }

  void Evaluate(const Parameters& p, float width, std::span<double> residuals) override {
    ++runs_;
    const double share = std::log(p.blend_a * (1 - 0.1 * p.blend_b) / truth_.share);
    const double slope = p.blend_b - truth_.slope;
    for (std::size_t t = 0; t < residuals.size(); ++t) {
      const Tile& tile = tiles_of_[t];
      double gate = 0;
      for (const Pixel& pixel : tile.pixels) {
        const double taken = Gate(pixel.difference, p.sr_depth_threshold, width);
        gate += pixel.wrong ? 0.2 * taken : 0.1 * (1 - taken);
      }
      gate = truth_.threshold_acts ? gate / static_cast<double>(tile.pixels.size()) : 0.0;
      const double s = share - tile.shift, b = slope - tile.turn;
      const double loss = tile.floor + truth_.scale * (gate + 0.02 * s * s + 0.01 * b * b);
      residuals[t] = std::sqrt(2 * loss / tiles_);
    }
  }

  // The share and slope with the least loss: where the tiles' own mean lies.
  Parameters Best() const {
    double shift = 0, turn = 0;
    for (const Tile& tile : tiles_of_) {
      shift += tile.shift / tiles_;
      turn += tile.turn / tiles_;
    }
    Parameters p;
    p.sr_depth_threshold = static_cast<float>(truth_.threshold);
    p.blend_b = static_cast<float>(truth_.slope + turn);
    p.blend_a = static_cast<float>(truth_.share * std::exp(shift) / (1 - 0.1 * p.blend_b));
    return p;
  }

 private:
  struct Pixel {
    float difference;
    bool wrong;
  };
  struct Tile {
    double shift, turn, floor;
    std::vector<Pixel> pixels;
  };

  Truth truth_;
  int tiles_;
  int runs_ = 0;
  std::vector<Tile> tiles_of_;
};

}  // namespace warplut
