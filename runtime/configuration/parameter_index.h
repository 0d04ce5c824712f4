// Where a calibrated number stands in kParameters.
#pragma once

#include <cstddef>
#include <string_view>

#include "runtime/parameters.h"

namespace warplut {

// The index in kParameters of that name, or -1.
constexpr int ParameterIndex(std::string_view name) {
  for (std::size_t i = 0; i < kParameters.size(); ++i) {
    if (name == kParameters[i].name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace warplut
