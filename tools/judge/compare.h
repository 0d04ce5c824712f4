// Image against image, folder against folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/image.h"

namespace warplut {

struct FrameScore {
  std::string name;
  double mean_squared_error = 0;  // over all channels
  double psnr = 0;                // dB; +infinity for equal images
  double ssim = 0;                // of luma
};

// Scores `a` against `b` without `border` pixels at each edge. Images of 1, 3 or 4 channels (alpha is ignored, and the
// error is over RGB then). An Error names `name` if sizes or channels differ or too little is left for the SSIM window.
FrameScore CompareImages(const std::string& name, const Image& a, const Image& b, int border);

// The files of two paths (datasets/image_list.h), paired by file name. An Error names the first
// file that has no partner.
struct FramePair {
  std::string name;
  std::filesystem::path a, b;
};
std::vector<FramePair> PairFrames(const std::filesystem::path& a, const std::filesystem::path& b);

// The means of `scores`; the PSNR is the mean of those that are finite, +infinity if none is.
FrameScore MeanScore(const std::vector<FrameScore>& scores);

}  // namespace warplut
