// Image against image, folder against folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/images/image_list.h"

namespace warplut {

struct FrameScore {
  std::string name;
  double mean_squared_error = 0;  // over all channels
  double psnr = 0;                // dB; +infinity for equal images
  double ssim = 0;                // of luma
};

// Scores `a` against `b` without `border` pixels at each edge. Images of 1, 3 or 4 channels (alpha
// is ignored, and the error is over RGB then). An Error names `name` if sizes or channels differ or
// too little is left for the SSIM window.
FrameScore CompareImages(const std::string& name, const Image& a, const Image& b, int border);

// The images of two paths (datasets/images/image_list.h), paired by file name. An Error names the
// first file that has no partner, or a name that a path has twice.
struct FramePair {
  std::string name;
  ListedImage a, b;
};
std::vector<FramePair> PairFrames(const std::filesystem::path& a, const std::filesystem::path& b);

// In which values two images are compared.
//   kStored     those of the files, integers from 0 to 1
//   kDisplayed  as a display shows linear HDR (train/metrics/displayed_color.h): so `eval` and
//               `run --score` judge it
enum class JudgedDomain : std::uint8_t { kStored, kDisplayed };
constexpr const char* Name(JudgedDomain domain) {
  return domain == JudgedDomain::kStored ? "stored" : "displayed";
}

// kDisplayed if `linear`, or if an image of the pairs is linear HDR, as its sequence says.
JudgedDomain DomainOf(const std::vector<FramePair>& pairs, bool linear);

// Loads an image as it is compared, without alpha. An Error names a file of integers in the domain
// kDisplayed: what it holds is displayed already.
Image LoadCompared(const ListedImage& listed, JudgedDomain domain);

// Loads and scores a pair. Errors as LoadCompared and CompareImages.
FrameScore ComparePair(const FramePair& pair, JudgedDomain domain, int border);

// The means of `scores`; the PSNR is the mean of those that are finite, +infinity if none is.
FrameScore MeanScore(const std::vector<FrameScore>& scores);

}  // namespace warplut
