// Filters with one parameter, of which the best is searched for.
#pragma once

#include <functional>
#include <string_view>

#include "tools/judge/images/warp_protocol.h"
#include "train/fit/rivals/golden_section.h"

namespace warplut {

// The names that stand for the filter whose parameter is best for the very protocol and images.
inline constexpr const char* kBestKeys = "best-keys";
inline constexpr const char* kBestSpline = "best-spline";

struct FilterFamily {
  const char* name;       // kBestKeys
  const char* parameter;  // "keys_a"
  const char* symbol;     // "a"
  double low, high;       // where the parameter is searched
  double width;           // how closely
  int digits;             // that tell such parameters apart
  ProtocolFilter (*make)(double parameter);

  // The parameter with the largest score, which is called for Evaluations() of them.
  Maximum Best(const std::function<double(double parameter)>& score) const;
  int Evaluations() const;
};

// The Keys kernel, and the cubic spline with any gain. Null if `name` is no family's.
const FilterFamily* FindFamily(std::string_view name);

}  // namespace warplut
