// The range and the tics of an axis of a plot.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace warplut {

class PlotAxis {
 public:
  // Covers the values that can be drawn, with some room at both ends; without any it is [0, 1],
  // logarithmic [1, 10].
  PlotAxis(bool logarithmic, std::span<const double> values);

  bool logarithmic() const { return logarithmic_; }
  double low() const { return low_; }
  double high() const { return high_; }

  // Whether the value is finite and, on a logarithmic axis, positive.
  bool CanDraw(double value) const;

  // 0 at low(), 1 at high(); the value can be drawn.
  double Share(double value) const;

  // At most about `most` values in the range, ascending: multiples of 1, 2 or 5 times a power of
  // ten; on a logarithmic axis 1, 2 and 5 times, 1 and 3 times, or every n-th power of ten.
  std::vector<double> Tics(int most) const;

 private:
  std::vector<double> LogarithmicTics(int most) const;

  bool logarithmic_;
  double low_, high_;
};

// As short as it can be: "0.001", "1e-05", "20".
std::string TicText(double value);

}  // namespace warplut
