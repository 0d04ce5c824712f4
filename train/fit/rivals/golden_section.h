// The largest value of a function of one variable.
#pragma once

#include <functional>

namespace warplut {

struct Maximum {
  double at = 0;
  double value = 0;
};

// How many times GoldenSection evaluates.
int GoldenSectionEvaluations(double low, double high, double width);

// The best of the points tried while golden-section search narrows [low, high] to at most `width`:
// within `width` of the maximum if `f` has only one. Source: Kiefer 1953.
Maximum GoldenSection(const std::function<double(double)>& f, double low, double high,
                      double width);

}  // namespace warplut
