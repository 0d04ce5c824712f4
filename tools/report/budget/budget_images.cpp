#include "tools/report/budget/budget_images.h"

#include <algorithm>

#include "train/metrics/luma.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

constexpr int kLocalRadius = 2;  // of the 5 x 5 pixels

// The sum over the (2 radius + 1)^2 pixels around each, as far as they lie in the image; 1 channel.
Image BoxSum(const Image& image, int radius) {
  if (radius == 0) return image;
  Image across(image.width, image.height, 1), sum(image.width, image.height, 1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      double total = 0;
      const int last = std::min(image.width - 1, x + radius);
      for (int u = std::max(0, x - radius); u <= last; ++u) total += image.at(u, y);
      across.at(x, y) = static_cast<float>(total);
    }
  }
  for (int y = 0; y < image.height; ++y) {
    const int last = std::min(image.height - 1, y + radius);
    for (int x = 0; x < image.width; ++x) {
      double total = 0;
      for (int v = std::max(0, y - radius); v <= last; ++v) total += across.at(x, v);
      sum.at(x, y) = static_cast<float>(total);
    }
  }
  return sum;
}

// The product of two differences of colours at each pixel, summed over channels.
Image Products(const Image& a, const Image& b, const Image& c, const Image& d) {
  Image products(a.width, a.height, 1);
  for (std::size_t p = 0; p < products.data.size(); ++p) {
    for (std::size_t i = 3 * p; i < 3 * p + 3; ++i) {
      products.data[p] += (a.data[i] - b.data[i]) * (c.data[i] - d.data[i]);
    }
  }
  return products;
}

}  // namespace

Image WarpedImage(const Image& image, const MotionView& motion, const WarpOptions& filter) {
  const ImageBuffer from = ToBuffer(image, PixelFormat::kRgba32F);
  ImageBuffer to(image.width, image.height, PixelFormat::kRgba32F);
  Warp(from.view(), motion, filter, to.view());
  Image warped = ToImage(to);
  for (float& value : warped.data) value = std::clamp(value, 0.0f, 1.0f);
  return warped;
}

void CopyMasked(const Image& from, const PixelMask& mask, Image& to) {
  for (std::size_t p = 0; p < mask.size(); ++p) {
    if (mask[p] == 0) continue;
    std::copy_n(&from.data[3 * p], 3, &to.data[3 * p]);
  }
}

Image LocalLumaError(const Image& image, const Image& reference, const PixelMask& mask) {
  Image error = Luma(image);
  const Image expected = Luma(reference);
  for (std::size_t p = 0; p < mask.size(); ++p) error.data[p] -= expected.data[p];
  Image weight(error.width, error.height, 1);
  for (std::size_t p = 0; p < mask.size(); ++p) {
    weight.data[p] = mask[p] != 0 ? 1.0f : 0.0f;
    if (mask[p] == 0) error.data[p] = 0;
  }
  Image mean = BoxSum(error, kLocalRadius);
  weight = BoxSum(weight, kLocalRadius);
  for (std::size_t p = 0; p < mask.size(); ++p) {
    mean.data[p] = weight.data[p] > 0 ? mean.data[p] / weight.data[p] : 0.0f;
  }
  return mean;
}

Image BestBlend(const Image& a, const Image& b, const Image& reference, int radius) {
  const Image along = BoxSum(Products(reference, a, b, a), radius);
  const Image length = BoxSum(Products(b, a, b, a), radius);
  Image best = a;
  for (std::size_t i = 0; i < best.data.size(); ++i) {
    const float l = length.data[i / 3];
    const float share = l > 0 ? std::clamp(along.data[i / 3] / l, 0.0f, 1.0f) : 0.0f;
    best.data[i] += share * (b.data[i] - a.data[i]);
  }
  return best;
}

void TakeNearer(const Image& from, const Image& reference, int radius, Image& to) {
  const Image there = BoxSum(Products(from, reference, from, reference), radius);
  const Image here = BoxSum(Products(to, reference, to, reference), radius);
  for (std::size_t i = 0; i < to.data.size(); ++i) {
    if (there.data[i / 3] < here.data[i / 3]) to.data[i] = from.data[i];
  }
}

}  // namespace warplut
