// Tables for tests: the weights of a closed form on the grid of a format, rows closed exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "luts/filters.h"
#include "luts/half.h"
#include "luts/table.h"
#include "luts/wide_kernel.h"

namespace warplut {

struct TestTable {
  std::vector<std::byte> bytes;
  TableFormat format;
  Prefilter prefilter = {};
  Footprint footprint = Footprint::k16;

  TableView view() const { return {format, bytes.data(), prefilter, footprint}; }
};

// `weights(dx, dy)` gives those of an offset.
template <class WeightsAt>
TestTable MakeTestTable(TableFormat format, const WeightsAt& weights,
                        Footprint footprint = Footprint::k16) {
  const std::size_t size = BytesPerWeight(format);
  const FootprintTaps& taps = TapsOf(footprint);
  TestTable table{std::vector<std::byte>(TableValues(footprint) * size), format};
  table.footprint = footprint;
  const double one = std::ldexp(1.0, FractionBits(format));
  for (int row = 0; row < kRows; ++row) {
    const Weights<double> w = weights(NodeOffset(row % kNodes), NodeOffset(row / kNodes));
    Weights<long> stored{};
    long rest = static_cast<long>(one);
    for (const int k : taps) {
      stored[k] = std::lround(w[k] * one);
      rest -= stored[k];
    }
    *std::max_element(stored.begin(), stored.end()) += rest;
    for (int i = 0; i < taps.count; ++i) {
      const int k = taps[i];
      std::byte* to = table.bytes.data() + static_cast<std::size_t>(row * taps.count + i) * size;
      const auto store = [&](auto value) { std::memcpy(to, &value, sizeof value); };
      const float weight = static_cast<float>(stored[k] / one);
      switch (format) {
        case TableFormat::kI16:
          store(static_cast<std::int16_t>(stored[k]));
          break;
        case TableFormat::kF16:
          store(FloatToHalf(weight));
          break;
        case TableFormat::kI8:
          store(static_cast<std::int8_t>(stored[k]));
          break;
        case TableFormat::kF32:
          store(weight);
          break;
      }
    }
  }
  return table;
}

inline TestTable MakeKeysTable(TableFormat format, double a = -0.58) {
  return MakeTestTable(format, [a](double dx, double dy) { return KeysWeights(a, dx, dy); });
}

// Of 24 or 36 taps: their wide kernel.
inline TestTable MakeWideTable(TableFormat format, Footprint footprint, double b = 4.5) {
  return MakeTestTable(
      format, [=](double dx, double dy) { return WideWeights(footprint, b, dx, dy); }, footprint);
}

// With the recursive prefilter of its side.
inline TestTable MakeSplineTable(TableFormat format, double k) {
  TestTable table =
      MakeTestTable(format, [k](double dx, double dy) { return SplineWeights(k, dx, dy); });
  table.prefilter = {.kind = PrefilterKind::kRecursive, .side = static_cast<float>(SplineSide(k))};
  return table;
}

inline constexpr TableFormat kTableFormats[] = {TableFormat::kI16, TableFormat::kF16,
                                                TableFormat::kI8, TableFormat::kF32};

}  // namespace warplut
