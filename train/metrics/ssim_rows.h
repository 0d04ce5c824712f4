// Rows for the SSIM kernels of every instruction set; internal to ssim.cpp.
#pragma once

#include <cstddef>

namespace warplut {

struct SsimRows {
  int width = 0;  // of the image
  int height = 0;
  std::ptrdiff_t stride = 0;    // of every row below; rows may be read and written in whole vectors
  const float* taps = nullptr;  // kSsimWindow
  const float* y = nullptr;
  const float* mean_y = nullptr;
  const float* var_y = nullptr;
  float* scratch = nullptr;  // kSsimScratchRows rows, zero at first
};

// Rings of 11 rows of e, e^2, e v and of the three derivatives, and six single rows.
inline constexpr int kSsimScratchRows = 6 * 11 + 6;

}  // namespace warplut
