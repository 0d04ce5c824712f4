#include "luts/quantize/baked_table.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "datasets/error.h"
#include "luts/filters.h"
#include "luts/footprint_names.h"
#include "luts/half.h"
#include "luts/quantize/real_table.h"

namespace warplut {
namespace {

template <class T, class Encode>
std::vector<T> Stored(const std::vector<IntegerRow>& rows, Footprint footprint,
                      const Encode& encode) {
  std::vector<T> stored;
  stored.reserve(static_cast<std::size_t>(TableValues(footprint)));
  for (const IntegerRow& row : rows) {
    for (const int k : TapsOf(footprint)) stored.push_back(encode(row[k]));
  }
  return stored;
}

// Where in the table value `index` is, for error sentences.
std::string Place(const TableView& view, const std::string& name, int index) {
  const int taps = TapCount(view.footprint);
  const int row = index / taps;
  return fmt::format("{}: weight {} of node ({}, {})", name, index % taps, row % kNodes,
                     row / kNodes);
}

float Unit(TableFormat format) { return std::ldexp(1.0f, -FractionBits(format)); }

std::int32_t IntegerOfFloat(float weight, const TableView& view, const std::string& name,
                            int index) {
  const TableFormat format = view.format;
  const float q = weight / Unit(format);
  if (!(std::abs(weight) <= 2) || q != std::floor(q) ||
      !CanStore(format, static_cast<std::int32_t>(q))) {
    throw Error(fmt::format("{} is {}, expected a multiple of 2^-{} in [-2, 2), as {} stores it",
                            Place(view, name, index), weight, FractionBits(format), Name(format)));
  }
  return static_cast<std::int32_t>(q);
}

std::int32_t IntegerAt(const TableView& view, const std::string& name, int index) {
  switch (view.format) {
    case TableFormat::kI16:
      return static_cast<const std::int16_t*>(view.data)[index];
    case TableFormat::kI8:
      return static_cast<const std::int8_t*>(view.data)[index];
    case TableFormat::kF16: {
      const float weight = HalfToFloat(static_cast<const std::uint16_t*>(view.data)[index]);
      return IntegerOfFloat(weight, view, name, index);
    }
    case TableFormat::kF32:
      return IntegerOfFloat(static_cast<const float*>(view.data)[index], view, name, index);
  }
  return 0;
}

// Row (0, 0) of a table with prefilter. The middle weight is the one that closes the sum for the
// eight others.
void CheckWholeOffset(const IntegerRow& row, const TableView& view, const std::string& name) {
  const double side = static_cast<double>(view.prefilter.side);
  const std::array<double, kTaps> taps = {side, 1 - 2 * side, side, 0};
  const Weights<double> expected = Separable(taps, taps);
  const Weights<double> found = RealRow(row, view.format);
  const FootprintTaps& stored = TapsOf(view.footprint);
  for (int i = 0; i < stored.count; ++i) {
    const int k = stored[i];
    const double bound = (k == kIdentityWeight ? 2 : 1) * WholeOffsetTolerance(view.format);
    if (std::abs(found[k] - expected[k]) <= bound) continue;
    throw Error(fmt::format(
        "{} is {}, expected {:.6f} of a prefilter with side {}: table and prefilter do not belong "
        "together",
        Place(view, name, i), found[k], expected[k], view.prefilter.side));
  }
}

}  // namespace

bool CanStore(TableFormat format, std::int32_t integer) {
  const std::int32_t one = 1 << FractionBits(format);
  if (integer < -2 * one || integer >= 2 * one) return false;
  return format != TableFormat::kF16 || std::abs(integer) <= one || integer % 2 == 0;
}

BakedTable::BakedTable(TableFormat format, const std::vector<IntegerRow>& rows,
                       const Prefilter& prefilter, Footprint footprint)
    : prefilter_(prefilter), footprint_(footprint) {
  const float unit = Unit(format);
  switch (format) {
    case TableFormat::kI16:
      storage_ = Stored<std::int16_t>(rows, footprint,
                                      [](auto q) { return static_cast<std::int16_t>(q); });
      break;
    case TableFormat::kF16:
      storage_ = Stored<std::uint16_t>(
          rows, footprint, [unit](auto q) { return FloatToHalf(unit * static_cast<float>(q)); });
      break;
    case TableFormat::kI8:
      storage_ =
          Stored<std::int8_t>(rows, footprint, [](auto q) { return static_cast<std::int8_t>(q); });
      break;
    case TableFormat::kF32:
      storage_ =
          Stored<float>(rows, footprint, [unit](auto q) { return unit * static_cast<float>(q); });
      break;
  }
}

TableView BakedTable::view() const {
  return {format(),
          std::visit([](const auto& v) { return static_cast<const void*>(v.data()); }, storage_),
          prefilter_, footprint_};
}

std::vector<IntegerRow> TableIntegers(const TableView& view, const std::string& name) {
  std::vector<IntegerRow> rows(kRows);
  const FootprintTaps& taps = TapsOf(view.footprint);
  int index = 0;
  for (IntegerRow& row : rows) {
    for (const int k : taps) row[k] = IntegerAt(view, name, index++);
  }
  return rows;
}

Weights<double> RealRow(const IntegerRow& row, TableFormat format) {
  Weights<double> w;
  for (int k = 0; k < kWeights; ++k) w[k] = std::ldexp(row[k], -FractionBits(format));
  return w;
}

void CheckTable(const TableView& view, const std::string& name) {
  const char* why = nullptr;
  if (!IsValid(view.prefilter, &why)) throw Error(fmt::format("{}: the prefilter {}", name, why));
  if (const std::string fault = FootprintFault(view.footprint, view.prefilter); !fault.empty()) {
    throw Error(fmt::format("{}: {}", name, fault));
  }
  const bool prefiltered = HasPrefilter(view.prefilter);
  const FootprintTaps& taps = TapsOf(view.footprint);
  const std::int32_t one = 1 << FractionBits(view.format);
  const std::vector<IntegerRow> rows = TableIntegers(view, name);
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      const int r = RowIndex(ix, jy);
      const std::int32_t sum = std::accumulate(rows[r].begin(), rows[r].end(), 0);
      if (sum != one) {
        throw Error(fmt::format("{}: the weights of node ({}, {}) sum to {} / {}, expected {} / {}",
                                name, ix, jy, sum, one, one, one));
      }
      for (int i = 0; i < taps.count; ++i) {
        const int k = taps[i], index = r * taps.count + i;
        if (rows[r][k] != 0 && IsContractZero(prefiltered, kNodes, ix, jy, k)) {
          throw Error(fmt::format(
              "{} is {} / {}, expected 0: a node with dx = 0 (dy = 0) has weights only in the "
              "column (row) of tap 0{}",
              Place(view, name, index), rows[r][k], one,
              prefiltered ? " and those beside it" : ""));
        }
        const int mirror = TapWeight(MirroredTap(prefiltered, kNodes, ix, TapX(k)),
                                     MirroredTap(prefiltered, kNodes, jy, TapY(k)));
        if (rows[r][k] != rows[r][mirror]) {
          throw Error(
              fmt::format("{} is {} / {}, expected {} as of tap ({}, {}): a node with dx = 0 (dy = "
                          "0) has equal "
                          "weights on both sides of tap 0",
                          Place(view, name, index), rows[r][k], one, rows[r][mirror], TapX(mirror),
                          TapY(mirror)));
        }
      }
    }
  }
  if (prefiltered) CheckWholeOffset(rows[0], view, name);
}

}  // namespace warplut
