// The instruction sets that kernels are compiled for: every one that Highway can choose at run
// time, except ARM's SVE. Kernels hold vectors in arrays and structs, which SVE's, of unknown size,
// cannot be in; a vector of four floats, as in NEON, fills those of mobile processors with SVE2 as
// well. Included before Highway, which takes what is defined first.
#pragma once

#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif

#include <hwy/targets.h>

#include "runtime/core/strict_math.h"

namespace warplut {

// The floats of the widest vectors that kernels use.
inline constexpr int kLargestLanes = 16;

}  // namespace warplut
