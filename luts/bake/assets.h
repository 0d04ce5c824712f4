// The tables that ship: a fit in luts/fits/NAME.json and what is baked from it in
// luts/baked/NAME.{h,json}, of 16 taps without prefilter also NAME.exr.
#pragma once

#include <array>
#include <string_view>

namespace warplut {

// One per upscale factor: 1.3, 1.5, 1.7, 2, 3, 4. First those of objective `warp`, for repeated
// warps alone, then those of objective `sr`, for the history of super resolution. Then those with a
// recursive prefilter, then those of more taps, both of objective `warp`.
inline constexpr std::array<std::string_view, 19> kAssets = {
    "warplut_x1_3",   "warplut_x1_5",    "warplut_x1_7",     "warplut_x2",       "warplut_x3",
    "warplut_x4",     "warplut_sr_x1_3", "warplut_sr_x1_5",  "warplut_sr_x1_7",  "warplut_sr_x2",
    "warplut_sr_x3",  "warplut_sr_x4",   "warplut_iir_x1_3", "warplut_iir_x1_5", "warplut_iir_x1_7",
    "warplut_iir_x2", "warplut_iir_x3",  "warplut_iir_x4",   "warplut_t24_x2"};

}  // namespace warplut
