#include "tools/pictures/shown_file.h"

#include <fmt/format.h>

#include <cmath>

#include "datasets/error.h"
#include "datasets/images/image_io.h"
#include "train/replay/image_views.h"

namespace warplut {

std::string ShownFileName(int first, double time, ShownFormat format) {
  const char* extension = format == ShownFormat::kPng ? "png" : "exr";
  const long thousandths = std::lround(1000 * time);
  const long number = first + thousandths / 1000;
  if (thousandths % 1000 == 0) return fmt::format("{:04}.{}", number, extension);
  return fmt::format("{:04}_{:03}.{}", number, thousandths % 1000, extension);
}

void WriteShownFrame(const std::filesystem::path& folder, int first, const ShownFrame& shown,
                     ColorEncoding encoding, ShownFormat format) {
  const std::filesystem::path path = folder / ShownFileName(first, shown.time, format);
  if (encoding == ColorEncoding::kLinearHdr && format == ShownFormat::kPng) {
    throw Error(fmt::format("'{}' would hold linear colour; expected .exr for it", path.string()));
  }
  WriteImage(path, ToImage(shown.image),
             format == ShownFormat::kPng ? PixelType::kUint8 : PixelType::kHalf);
}

}  // namespace warplut
