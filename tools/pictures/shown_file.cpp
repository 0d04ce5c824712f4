#include "tools/pictures/shown_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "datasets/error.h"
#include "datasets/images/image_io.h"
#include "train/replay/image_views.h"

namespace warplut {

namespace {

Image WithAlpha(const Image& premultiplied, const Image& alpha, bool straight) {
  Image image(alpha.width, alpha.height, 4);
  for (std::size_t i = 0; i < alpha.data.size(); ++i) {
    const float a = alpha.data[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = premultiplied.data[3 * i + c];
      image.data[4 * i + c] = straight ? (a > 0 ? std::min(value / a, 1.0F) : 0) : value;
    }
    image.data[4 * i + 3] = a;
  }
  return image;
}

}  // namespace

std::string ShownFileName(int first, double time, ShownFormat format) {
  const char* extension = format == ShownFormat::kPng ? "png" : "exr";
  const long thousandths = std::lround(1000 * time);
  const long number = first + thousandths / 1000;
  if (thousandths % 1000 == 0) return fmt::format("{:04}.{}", number, extension);
  return fmt::format("{:04}_{:03}.{}", number, thousandths % 1000, extension);
}

void WriteShownFrame(const std::filesystem::path& folder, int first, const ShownFrame& shown,
                     ColorEncoding encoding, ShownFormat format, const Image* alpha) {
  const std::filesystem::path path = folder / ShownFileName(first, shown.time, format);
  if (encoding == ColorEncoding::kLinearHdr && format == ShownFormat::kPng) {
    throw Error(fmt::format("'{}' would hold linear colour; expected .exr for it", path.string()));
  }
  Image image = ToImage(shown.image);
  if (alpha != nullptr) image = WithAlpha(image, *alpha, format == ShownFormat::kPng);
  WriteImage(path, image, format == ShownFormat::kPng ? PixelType::kUint8 : PixelType::kHalf);
}

}  // namespace warplut
