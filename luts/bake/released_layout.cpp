#include "luts/bake/released_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "datasets/error.h"
#include "luts/quantize/quantize.h"

namespace warplut {
namespace {

// Where the pixel of weight k of node (ix, jy) is.
int PixelX(int k, int ix) { return (TapX(k) - kFirstTap) * kNodes + ix; }
int PixelY(int k, int jy) { return (TapY(k) - kFirstTap) * kNodes + jy; }

constexpr int kLast = kReleasedIntervals;

void CheckRow(const RealTable& table, int ix, int jy) {
  const Weights<double>& row = table.Row(ix, jy);
  const double sum = std::accumulate(row.begin(), row.end(), 0.0);
  if (!(std::abs(sum - 1) <= kReleasedTolerance)) {
    throw Error(fmt::format(
        "{}: the weights of node ({}, {}) sum to {}, expected 1 within {}; is this the layout of "
        "4 x 4 tiles?",
        table.name, ix, jy, sum, kReleasedTolerance));
  }
  const FootprintTaps& taps = TapsOf(Footprint::k16);
  for (int i = 0; i < taps.count; ++i) {
    const int k = taps[i];
    if (IsContractZero(false, kLast, ix, jy, k) && !(std::abs(row[k]) <= kReleasedTolerance)) {
      throw Error(fmt::format(
          "{}: weight {} of node ({}, {}) is {}, expected 0 within {}, as this offset is on the "
          "border of its cell",
          table.name, i, ix, jy, row[k], kReleasedTolerance));
    }
  }
}

// The cells on both sides of a border must agree on it: column 1 at dx = 1 is column 0 at dx = 0,
// and so for dy.
void CheckSeam(const RealTable& table) {
  for (int i = 0; i <= kLast; ++i) {
    for (int t = kFirstTap; t < kFirstTap + kTaps; ++t) {
      const double x = table.Row(kLast, i)[TapWeight(1, t)] - table.Row(0, i)[TapWeight(0, t)];
      const double y = table.Row(i, kLast)[TapWeight(t, 1)] - table.Row(i, 0)[TapWeight(t, 0)];
      if (std::abs(x) <= kReleasedTolerance && std::abs(y) <= kReleasedTolerance) continue;
      throw Error(
          fmt::format("{}: the weights at node {} of the first and last {} differ by {}, expected "
                      "at most {}, as "
                      "neighbouring cells meet there",
                      table.name, i, std::abs(x) > kReleasedTolerance ? "column" : "row",
                      std::max(std::abs(x), std::abs(y)), kReleasedTolerance));
    }
  }
}

}  // namespace

Image ToReleasedLayout(const Fit& fit) {
  if (HasPrefilter(fit.prefilter)) {
    throw Error(
        fmt::format("fit '{}' has a prefilter; expected one without, as the released layout "
                    "holds a table alone",
                    fit.name));
  }
  if (fit.footprint != Footprint::k16) {
    throw Error(fmt::format(
        "fit '{}' has {} taps; expected {}, as the released layout holds no other table", fit.name,
        TapCount(fit.footprint), TapCount(Footprint::k16)));
  }
  const RealTable real = SampleFit(fit, kReleasedIntervals);
  const std::vector<IntegerRow> rows = RoundTable(real, TableFormat::kF32);
  Image image(kReleasedSide, kReleasedSide, 1);
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      const Weights<double> w = RealRow(rows[real.RowAt(ix, jy)], TableFormat::kF32);
      for (const int k : TapsOf(Footprint::k16)) {
        image.at(PixelX(k, ix), PixelY(k, jy)) = static_cast<float>(w[k]);
      }
    }
  }
  return image;
}

RealTable FromReleasedLayout(const Image& image, const std::string& name) {
  if (image.width != kReleasedSide || image.height != kReleasedSide || image.channels != 1) {
    throw Error(fmt::format("{}: is {} x {} with {} channel(s), expected {} x {} with one", name,
                            image.width, image.height, image.channels, kReleasedSide,
                            kReleasedSide));
  }
  RealTable table{
      .name = name, .intervals = kReleasedIntervals, .rows = std::vector<Weights<double>>(kRows)};
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      Weights<double>& row = table.rows[table.RowAt(ix, jy)];
      for (const int k : TapsOf(Footprint::k16)) row[k] = image.at(PixelX(k, ix), PixelY(k, jy));
      CheckRow(table, ix, jy);
    }
  }
  CheckSeam(table);
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      Weights<double>& row = table.rows[table.RowAt(ix, jy)];
      for (int k = 0; k < kWeights; ++k) {
        if (IsContractZero(false, kLast, ix, jy, k)) row[k] = 0;
      }
      CloseSum(&row, static_cast<double>(ix) / kLast, static_cast<double>(jy) / kLast);
    }
  }
  return table;
}

}  // namespace warplut
