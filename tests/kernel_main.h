// Questions that tests of kernels may ask their main function (kernel_main.cpp).
#pragma once

#include <cstddef>
#include <vector>

namespace warplut {

// Whether long runs are worth their time: on the widest instruction set of this processor, once for
// each test, without sanitizers, which learn nothing from repetition.
bool LongRuns();

// All cases in long runs, else every seventh.
template <class Case>
std::vector<Case> SomeOf(const std::vector<Case>& cases) {
  if (LongRuns()) return cases;
  std::vector<Case> some;
  for (std::size_t i = 0; i < cases.size(); i += 7) some.push_back(cases[i]);
  return some;
}

}  // namespace warplut
