#include "tools/judge/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "datasets/error.h"
#include "datasets/image_list.h"
#include "tools/judge/image_set.h"
#include "tools/judge/plane.h"
#include "train/metrics/luma.h"
#include "train/metrics/psnr.h"
#include "train/metrics/ssim.h"

namespace warplut {
FrameScore CompareImages(const std::string& name, const Image& a, const Image& b, int border) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) {
    throw Error(fmt::format(
        "{} is {} x {} with {} channels in one folder and {} x {} with {} in the other.", name,
        a.width, a.height, a.channels, b.width, b.height, b.channels));
  }
  const int side = kSsimWindow + 2 * border;
  if (a.width < side || a.height < side) {
    throw Error(fmt::format(
        "{} is {} x {}; expected at least {} x {} for the SSIM window and a border of {}.", name,
        a.width, a.height, side, side, border));
  }
  FrameScore score;
  score.name = name;
  score.mean_squared_error = MeanSquaredError(WithoutAlpha(a), WithoutAlpha(b), border);
  score.psnr = Psnr(score.mean_squared_error);
  const Image luma_a = Luma(a);
  const Image luma_b = Luma(b);
  score.ssim = Ssim(InnerPlane(luma_b, border)).Mean(InnerPlane(luma_a, border));
  return score;
}

std::vector<FramePair> PairFrames(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::map<std::string, std::filesystem::path> partners;
  for (const auto& file : ListImages(b)) partners.emplace(file.filename().string(), file);
  std::vector<FramePair> pairs;
  for (const auto& file : ListImages(a)) {
    const std::string name = file.filename().string();
    const auto partner = partners.find(name);
    if (partner == partners.end()) {
      throw Error(
          fmt::format("{} has no image of the same name in {}.", file.string(), b.string()));
    }
    pairs.push_back({.name = name, .a = file, .b = partner->second});
    partners.erase(partner);
  }
  if (!partners.empty()) {
    throw Error(fmt::format("{} has no image of the same name in {}.",
                            partners.begin()->second.string(), a.string()));
  }
  return pairs;
}

FrameScore MeanScore(const std::vector<FrameScore>& scores) {
  FrameScore mean;
  mean.name = "mean";
  int differing = 0;
  for (const FrameScore& score : scores) {
    mean.mean_squared_error += score.mean_squared_error;
    mean.ssim += score.ssim;
    if (std::isinf(score.psnr)) continue;
    mean.psnr += score.psnr;
    ++differing;
  }
  const auto count = static_cast<double>(scores.size());
  mean.mean_squared_error /= count;
  mean.psnr = differing > 0 ? mean.psnr / differing : std::numeric_limits<double>::infinity();
  mean.ssim /= count;
  return mean;
}

}  // namespace warplut
