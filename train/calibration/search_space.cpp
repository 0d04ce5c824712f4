#include "train/calibration/search_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace warplut {

SearchSpace::SearchSpace(std::vector<int> fitted, const Parameters& base)
    : fitted_(std::move(fitted)), base_(base) {}

double SearchSpace::Coordinate(int i, double value) const {
  const ParameterInfo& p = info(i);
  const double min = p.min, max = p.max;
  const double v = std::clamp(value, min, max);
  return p.logarithmic ? std::log(v / min) / std::log(max / min) : (v - min) / (max - min);
}

double SearchSpace::Value(int i, double coordinate) const {
  const ParameterInfo& p = info(i);
  const double min = p.min, max = p.max;
  const double u = std::clamp(coordinate, 0.0, 1.0);
  const double value = p.logarithmic ? min * std::pow(max / min, u) : min + u * (max - min);
  return std::clamp(value, min, max);
}

double SearchSpace::Slope(int i, double coordinate) const {
  const ParameterInfo& p = info(i);
  const double min = p.min, max = p.max;
  return p.logarithmic ? Value(i, coordinate) * std::log(max / min) : max - min;
}

Point SearchSpace::ToPoint(const Parameters& parameters) const {
  Point point;
  for (int i = 0; i < size(); ++i) point.push_back(Coordinate(i, parameters.*info(i).member));
  return point;
}

Parameters SearchSpace::ToParameters(std::span<const double> point) const {
  Parameters parameters = base_;
  for (int i = 0; i < size(); ++i) {
    const ParameterInfo& p = info(i);
    parameters.*p.member =
        std::clamp(static_cast<float>(Value(i, point[static_cast<std::size_t>(i)])), p.min, p.max);
  }
  return parameters;
}

double Distance(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace warplut
