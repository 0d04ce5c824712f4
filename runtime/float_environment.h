// The floating-point environment that the runtime computes in, whatever that of its caller.
//
// Sums are rounded to nearest, ties to even. Subnormals are flushed: an operand below 2^-126 counts
// as zero, and a result below it is zero, of its sign. (Processors take some twenty times as long
// for subnormals.) What is copied and not computed, as by a warp of whole pixels, keeps its bits;
// subnormal halves are normal floats and count. No exception traps.
//
// Every function of the runtime that works on images or tables sets this for its own duration, as
// does every piece that an Executor runs: the same bits whatever the caller's environment
// (-ffast-math sets that of a whole program), which is as it was afterwards, its exception flags
// too. Formulas in headers (runtime/gates.h, runtime/color_encoding.h, ...) are computed as their
// caller computes.
//
// Held on x86 (MXCSR) and 64-bit ARM (FPCR); elsewhere the environment is the caller's.
#pragma once

#include <cstdint>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

// Sets the environment of this thread for its own lifetime. They nest.
class FloatEnvironment {
 public:
  FloatEnvironment();
  ~FloatEnvironment();
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
  std::uint64_t caller_;  // control and status as they were
};

}  // namespace warplut
