#include "luts/bake/exr.h"

#include <cstdint>
#include <string_view>

#include "luts/bake/little_endian.h"

namespace warplut {
namespace {

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kVersion = 2;  // single-part scan-line file, names of at most 31 characters
constexpr std::uint32_t kFloatPixels = 2;
constexpr char kNoCompression = 0;
constexpr char kIncreasingY = 0;

std::string Terminated(std::string_view text) { return std::string(text) + '\0'; }

std::string Side(int value) { return Bytes(static_cast<std::uint32_t>(value)); }

std::string Attribute(std::string_view name, std::string_view type, const std::string& value) {
  return Terminated(name) + Terminated(type) + Bytes32(value.size()) + value;
}

}  // namespace

std::string EncodeExr(const Image& image) {
  const std::string channels =
      Terminated("Y") + Bytes(kFloatPixels) + Bytes32(0) + Bytes32(1) + Bytes32(1) + '\0';
  const std::string window =
      Bytes32(0) + Bytes32(0) + Side(image.width - 1) + Side(image.height - 1);
  std::string file = Bytes(kMagic) + Bytes(kVersion);
  file += Attribute("channels", "chlist", channels);
  file += Attribute("compression", "compression", std::string(1, kNoCompression));
  file += Attribute("dataWindow", "box2i", window);
  file += Attribute("displayWindow", "box2i", window);
  file += Attribute("lineOrder", "lineOrder", std::string(1, kIncreasingY));
  file += Attribute("pixelAspectRatio", "float", BytesOf(1.0f));
  file += Attribute("screenWindowCenter", "v2f", BytesOf(0.0f) + BytesOf(0.0f));
  file += Attribute("screenWindowWidth", "float", BytesOf(1.0f));
  file += '\0';

  // Each scan line: its y, its length in bytes, its pixels. Before them the offset of each in the
  // file.
  const int line_bytes = image.width * 4;
  std::uint64_t offset = file.size() + static_cast<std::uint64_t>(image.height) * 8;
  for (int y = 0; y < image.height; ++y) {
    file += Bytes(offset);
    offset += 8 + static_cast<std::uint64_t>(line_bytes);
  }
  for (int y = 0; y < image.height; ++y) {
    file += Side(y) + Side(line_bytes);
    for (int x = 0; x < image.width; ++x) file += BytesOf(image.at(x, y));
  }
  return file;
}

}  // namespace warplut
