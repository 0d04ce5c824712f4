// How far a stored table is from the one that it was rounded from.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "luts/quantize/baked_table.h"
#include "luts/quantize/real_table.h"

namespace warplut {

// The worst sum over a row of |stored weight - weight|.
inline double QuantizationError(const RealTable& table, const TableView& stored) {
  const std::vector<IntegerRow> rows = TableIntegers(stored, table.name);
  double worst = 0;
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      const Weights<double> w = RealRow(rows[RowIndex(ix, jy)], stored.format);
      double sum = 0;
      for (int k = 0; k < kWeights; ++k) sum += std::abs(w[k] - table.Row(ix, jy)[k]);
      worst = std::max(worst, sum);
    }
  }
  return worst;
}

}  // namespace warplut
