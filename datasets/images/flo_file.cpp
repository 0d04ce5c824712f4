#include "datasets/images/flo_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "datasets/file.h"
#include "datasets/images/image_message.h"

namespace warplut {
namespace {

static_assert(std::endian::native == std::endian::little, "the values are copied as they are");

constexpr char kFloMagic[] = {'P', 'I', 'E', 'H'};
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kMaxBytes = kHeaderBytes + std::size_t{8} * kMaxImageSide * kMaxImageSide;

// The size that the header tells, of a file that is `bytes` long.
Image SizedAs(const std::filesystem::path& path, const char* header, std::uintmax_t bytes) {
  if (bytes < kHeaderBytes || std::memcmp(header, kFloMagic, sizeof(kFloMagic)) != 0) {
    RefuseImage(path, "it is no .flo file; expected one that begins with PIEH");
  }
  std::int32_t size[2];
  std::memcpy(size, header + sizeof(kFloMagic), sizeof(size));
  for (const std::int32_t side : size) {
    if (side < 1 || side > kMaxImageSide) {
      RefuseImage(path, fmt::format("its size is {} x {}; expected sides from 1 to {}", size[0],
                                    size[1], kMaxImageSide));
    }
  }
  Image image;
  image.width = size[0];
  image.height = size[1];
  image.channels = 2;
  const std::uintmax_t expected = kHeaderBytes + 8 * image.pixels();
  if (bytes != expected) {
    RefuseImage(path, fmt::format("it is {} bytes long; expected {} for {} x {} pixels", bytes,
                                  expected, size[0], size[1]));
  }
  return image;
}

}  // namespace

ImageInfo ReadFloInfo(const std::filesystem::path& path) {
  std::string header = ReadFileStart(path, kHeaderBytes);
  header.resize(kHeaderBytes);
  const Image sized = SizedAs(path, header.data(), std::filesystem::file_size(path));
  return {.width = sized.width,
          .height = sized.height,
          .channels = {"X", "Y"},
          .bits = 32,
          .integer = false};
}

Image ReadFlo(const std::filesystem::path& path) {
  const std::string bytes = ReadFile(path, kMaxBytes);
  Image image = SizedAs(path, bytes.data(), bytes.size());
  image.data.resize(image.pixels() * 2);
  std::memcpy(image.data.data(), bytes.data() + kHeaderBytes, image.data.size() * sizeof(float));
  for (std::size_t i = 0; i < image.data.size(); i += 2) {
    const auto known = [](float v) { return std::abs(v) <= kFloUnknown; };
    if (known(image.data[i]) && known(image.data[i + 1])) continue;
    image.data[i] = image.data[i + 1] = std::numeric_limits<float>::quiet_NaN();
  }
  return image;
}

}  // namespace warplut
