#include "luts/quantize/lookup_error.h"

#include <algorithm>
#include <cmath>

#include "luts/fit/symmetry.h"
#include "luts/quantize/quantize.h"
#include "luts/quantize/real_table.h"

namespace warplut {
namespace {

// The head's weights at (i, j) / kErrorOffsets, from those with 0 <= dy <= dx <= 1/2: the head has
// the 8 symmetries.
class ExactWeights {
 public:
  explicit ExactWeights(const Fit& fit) : rows_((kHalf + 1) * (kHalf + 1)) {
    for (int j = 0; j <= kHalf; ++j) {
      for (int i = j; i <= kHalf; ++i) {
        rows_[j * (kHalf + 1) + i] = FitWeights(fit, static_cast<double>(i) / kErrorOffsets,
                                                static_cast<double>(j) / kErrorOffsets);
      }
    }
  }

  Weights<double> At(int i, int j) const {
    const int flips = (i > kHalf ? 1 : 0) | (j > kHalf ? 2 : 0);
    const auto [x, y] = MapOffset<int>(flips, i, j, kErrorOffsets);
    const int g = flips | (y > x ? 4 : 0);
    const Weights<double>& row = rows_[std::min(x, y) * (kHalf + 1) + std::max(x, y)];
    Weights<double> w;
    for (int k = 0; k < kWeights; ++k) w[k] = row[MapWeight(g, k)];
    return w;
  }

 private:
  static constexpr int kHalf = kErrorOffsets / 2;
  std::vector<Weights<double>> rows_;
};

LookupError Measure(const ExactWeights& exact, const Table& table, TableFormat format,
                    Lookup lookup) {
  LookupError error{format, lookup, 0, 0, 0};
  for (int j = 0; j < kErrorOffsets; ++j) {
    for (int i = 0; i < kErrorOffsets; ++i) {
      const Weights<double> want = exact.At(i, j);
      const Weights<float> got = table.At(static_cast<float>(i) / kErrorOffsets,
                                          static_cast<float>(j) / kErrorOffsets, lookup);
      double distance = 0;
      double sum = 0;
      for (int k = 0; k < kWeights; ++k) {
        distance += std::abs(got[k] - want[k]);
        sum += got[k];
      }
      error.worst = std::max(error.worst, distance);
      error.mean += distance / (kErrorOffsets * kErrorOffsets);
      error.brightness = std::max(error.brightness, std::abs(sum - 1));
    }
  }
  return error;
}

}  // namespace

std::vector<LookupError> MeasureLookupErrors(const Fit& fit) {
  const RealTable real = SampleFit(fit, kNodes);
  const ExactWeights exact(fit);
  std::vector<LookupError> errors;
  for (const TableFormat format :
       {TableFormat::kI16, TableFormat::kF16, TableFormat::kI8, TableFormat::kF32}) {
    const Table table(Quantize(real, format).view());
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      errors.push_back(Measure(exact, table, format, lookup));
    }
  }
  return errors;
}

}  // namespace warplut
