#include "luts/quantize/quantize.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "datasets/error.h"
#include "luts/fit/symmetry.h"
#include "luts/quantize/row_closure.h"

namespace warplut {
namespace {

// The numbers that a table is rounded to: integers of the grid / one.
struct Storage {
  const char* name;
  std::int32_t one;
  RoundingGrid grid;
};

Storage StorageOf(TableFormat format) {
  const std::int32_t one = 1 << FractionBits(format);
  return {Name(format), one, {-2 * one, 2 * one - 1, format == TableFormat::kF16 ? one : 2 * one}};
}

// A half has 11 binary digits.
Storage HalfStorage() {
  constexpr std::int32_t kOne = 1 << kHalfFractionBits;
  return {"halves", kOne, {-2 * kOne, 2 * kOne - 1, 1 << 11, kMostHalfStep}};
}

void CheckRow(const RealTable& table, const Storage& storage, int ix, int jy) {
  const Weights<double>& row = table.Row(ix, jy);
  const double one = storage.one;
  double sum = 0;
  const FootprintTaps& taps = TapsOf(table.footprint);
  for (int i = 0; i < taps.count; ++i) {
    const int k = taps[i];
    const double w = row[k];
    const auto fail = [&](const char* expected) {
      throw Error(fmt::format("{}: weight {} of node ({}, {}) is {}, expected {}", table.name, i,
                              ix, jy, w, expected));
    };
    if (!std::isfinite(w)) fail("a finite number");
    const double rounded = std::round(w * one);
    if (rounded < -2 * one || rounded > 2 * one - 1) fail("a weight in [-2, 2)");
    if (IsContractZero(HasPrefilter(table.prefilter), table.intervals, ix, jy, k) &&
        std::abs(w) > kClosureTolerance) {
      fail("0, as this offset is on the border of its cell");
    }
    sum += w;
  }
  if (std::abs(sum - 1) > kClosureTolerance) {
    throw Error(fmt::format("{}: the weights of node ({}, {}) sum to {}, expected 1", table.name,
                            ix, jy, sum));
  }
}

// Groups of taps that must have equal weights: those that the symmetries in `group` which leave the
// node in place exchange, and with a prefilter those that mirror each other about a whole offset.
// Contract zeros are left out.
std::vector<std::vector<int>> TapGroups(const RealTable& table, int ix, int jy, int group) {
  const int intervals = table.intervals;
  const bool prefiltered = HasPrefilter(table.prefilter);
  std::vector<std::vector<int>> groups;
  for (const int k : TapsOf(table.footprint)) {
    if (IsContractZero(prefiltered, intervals, ix, jy, k)) continue;
    std::vector<int> taps;
    for (int g = 0; g < group; ++g) {
      if (MapOffset<int>(g, ix, jy, intervals) != std::array<int, 2>{ix, jy}) continue;
      const int image = MapWeight(g, k);
      const int x = TapX(image), y = TapY(image);
      const int mirrored_x = MirroredTap(prefiltered, intervals, ix, x);
      const int mirrored_y = MirroredTap(prefiltered, intervals, jy, y);
      for (const int tx : {x, mirrored_x}) {
        for (const int ty : {y, mirrored_y}) taps.push_back(TapWeight(tx, ty));
      }
    }
    std::sort(taps.begin(), taps.end());
    taps.erase(std::unique(taps.begin(), taps.end()), taps.end());
    if (taps.front() == k) groups.push_back(taps);
  }
  return groups;
}

IntegerRow RoundRow(const RealTable& table, const Storage& storage, int ix, int jy, int group) {
  const std::int32_t one = storage.one;
  const Weights<double>& row = table.Row(ix, jy);
  const std::vector<std::vector<int>> groups = TapGroups(table, ix, jy, group);
  std::vector<RoundingTerm> terms;
  for (const std::vector<int>& taps : groups) {
    double mean = 0;
    for (const int k : taps) mean += row[k] / static_cast<double>(taps.size());
    terms.push_back({mean * one, static_cast<int>(taps.size()), 0});
  }
  if (!RoundToSum(one, storage.grid, &terms)) {
    throw Error(fmt::format(
        "{}: the weights of node ({}, {}) have no rounding to {} with sum 1, expected one "
        "within {} units of each weight",
        table.name, ix, jy, storage.name, storage.grid.most_step));
  }
  IntegerRow rounded{};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const int k : groups[i]) rounded[k] = terms[i].rounded;
  }
  return rounded;
}

std::vector<IntegerRow> RoundTo(const Storage& storage, const RealTable& table) {
  const int n = table.intervals;
  for (int jy = 0; jy <= n; ++jy) {
    for (int ix = 0; ix <= n; ++ix) CheckRow(table, storage, ix, jy);
  }
  const int group = Asymmetry(table) <= kSymmetryTolerance ? kSymmetries : 1;
  std::vector<IntegerRow> rows(table.rows.size());
  for (int jy = 0; jy <= n; ++jy) {
    for (int ix = 0; ix <= n; ++ix) {
      // The first node of an orbit in storage order stands for all.
      int first = table.RowAt(ix, jy);
      for (int g = 0; g < group; ++g) {
        const auto [gx, gy] = MapOffset<int>(g, ix, jy, n);
        first = std::min(first, table.RowAt(gx, gy));
      }
      if (first != table.RowAt(ix, jy)) continue;
      const IntegerRow rounded = RoundRow(table, storage, ix, jy, group);
      for (int g = 0; g < group; ++g) {
        const auto [gx, gy] = MapOffset<int>(g, ix, jy, n);
        for (int k = 0; k < kWeights; ++k) rows[table.RowAt(gx, gy)][MapWeight(g, k)] = rounded[k];
      }
    }
  }
  return rows;
}

// The rows that are stored, of a table with kNodes intervals.
std::vector<IntegerRow> StoredRows(const RealTable& table, const std::vector<IntegerRow>& rounded) {
  std::vector<IntegerRow> rows(kRows);
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) rows[RowIndex(ix, jy)] = rounded[table.RowAt(ix, jy)];
  }
  return rows;
}

}  // namespace

std::vector<IntegerRow> RoundTable(const RealTable& table, TableFormat format) {
  return RoundTo(StorageOf(format), table);
}

BakedTable Quantize(const RealTable& table, TableFormat format) {
  return {format, StoredRows(table, RoundTable(table, format)), table.prefilter, table.footprint};
}

BakedTable QuantizeToHalves(const RealTable& table) {
  constexpr int kUnit = 1 << (FractionBits(TableFormat::kF32) - kHalfFractionBits);
  std::vector<IntegerRow> rows = StoredRows(table, RoundTo(HalfStorage(), table));
  for (IntegerRow& row : rows) {
    for (std::int32_t& q : row) q *= kUnit;
  }
  return {TableFormat::kF32, rows, table.prefilter, table.footprint};
}

}  // namespace warplut
