#include "train/metrics/psnr.h"

#include <cmath>

namespace warplut {

double MeanSquaredError(const Image& a, const Image& b, int border) {
  double total = 0;
  for (int y = border; y < a.height - border; ++y) {
    double row = 0;
    for (int x = border; x < a.width - border; ++x) {
      for (int c = 0; c < a.channels; ++c) {
        const double difference = static_cast<double>(a.at(x, y, c)) - b.at(x, y, c);
        row += difference * difference;
      }
    }
    total += row;
  }
  return total / (static_cast<double>(a.width - 2 * border) * (a.height - 2 * border) * a.channels);
}

double Psnr(double mean_squared_error) { return -10 * std::log10(mean_squared_error); }

}  // namespace warplut
