#include "train/fit/rollout/crops.h"

#include <cmath>
#include <optional>

#include "train/fit/random.h"

namespace warplut {
namespace {

constexpr int kTries = 8;

struct Place {
  int x = 0;
  int y = 0;
  double gradient = -1;
};

double MeanGradient(const Image& image, int x0, int y0, int size) {
  double sum = 0;
  for (int y = y0; y < y0 + size - 1; ++y) {
    for (int x = x0; x < x0 + size - 1; ++x) {
      sum += std::abs(image.at(x + 1, y) - image.at(x, y)) +
             std::abs(image.at(x, y + 1) - image.at(x, y));
    }
  }
  return sum / (2.0 * (size - 1) * (size - 1));
}

Place DrawPlace(const Image& image, int size, Random& random) {
  Place best;
  for (int i = 0; i < kTries && best.gradient < kMinCropGradient; ++i) {
    Place place{random.Below(image.width - size + 1), random.Below(image.height - size + 1)};
    place.gradient = MeanGradient(image, place.x, place.y, size);
    if (place.gradient > best.gradient) best = place;
  }
  return best;
}

}  // namespace

std::vector<BorderedPlane> DrawCrops(const std::vector<Image>& luma, int count, std::uint64_t seed,
                                     int size) {
  std::vector<BorderedPlane> crops;
  crops.reserve(count);
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Image& image = luma[i % luma.size()];
    const Place place = DrawPlace(image, size, random);
    BorderedPlane& crop = crops.emplace_back(size, size);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) crop.row(y)[x] = image.at(place.x + x, place.y + y);
    }
    FillBorder(crop);
  }
  return crops;
}

}  // namespace warplut
