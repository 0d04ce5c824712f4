// Included by the sources of the runtime: they cannot keep their promises about NaN and equal bits
// with fast-math.
#pragma once

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(_M_FP_FAST)
#error "warplut's runtime cannot be compiled with -ffast-math; add -fno-fast-math for its sources"
#endif
