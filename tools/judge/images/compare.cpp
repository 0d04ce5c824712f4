#include "tools/judge/images/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "datasets/error.h"
#include "datasets/images/image_io.h"
#include "tools/judge/images/image_set.h"
#include "tools/judge/images/plane.h"
#include "train/metrics/luma.h"
#include "train/metrics/psnr.h"
#include "train/metrics/ssim.h"

namespace warplut {
namespace {

std::map<std::string, ListedImage> ByName(const std::filesystem::path& path) {
  std::map<std::string, ListedImage> images;
  for (ListedImage& image : ListImages(path)) {
    const std::string name = image.file.filename().string();
    if (!images.emplace(name, std::move(image)).second) {
      throw Error(
          fmt::format("{} has two images of the name {}; expected one, to tell its partner.",
                      path.string(), name));
    }
  }
  return images;
}

}  // namespace

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
  const auto lacks_partner = [](const ListedImage& image, const std::filesystem::path& other) {
    throw Error(fmt::format("{} has no image of the same name in {}.", image.file.string(),
                            other.string()));
  };
  std::map<std::string, ListedImage> of_a = ByName(a), of_b = ByName(b);
  std::vector<FramePair> pairs;
  for (auto& [name, image] : of_a) {
    const auto partner = of_b.find(name);
    if (partner == of_b.end()) lacks_partner(image, b);
    pairs.push_back({.name = name, .a = std::move(image), .b = std::move(partner->second)});
    of_b.erase(partner);
  }
  if (!of_b.empty()) lacks_partner(of_b.begin()->second, a);
  return pairs;
}

JudgedDomain DomainOf(const std::vector<FramePair>& pairs, bool linear) {
  const bool displayed = linear || std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) {
                           return pair.a.IsLinear() || pair.b.IsLinear();
                         });
  return displayed ? JudgedDomain::kDisplayed : JudgedDomain::kStored;
}

Image LoadCompared(const ListedImage& listed, JudgedDomain domain) {
  Image image = WithoutAlpha(LoadListedImage(listed));
  if (domain == JudgedDomain::kStored) return image;
  const bool displayed = listed.sequence ? !listed.IsLinear() : ReadImageInfo(listed.file).integer;
  if (displayed) {
    throw Error(fmt::format(
        "{} holds displayed colour and cannot be compared as linear HDR; expected float values.",
        listed.file.string()));
  }
  return DisplayedImage(std::move(image), ColorEncoding::kLinearHdr);
}

FrameScore ComparePair(const FramePair& pair, JudgedDomain domain, int border) {
  return CompareImages(pair.name, LoadCompared(pair.a, domain), LoadCompared(pair.b, domain),
                       border);
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
