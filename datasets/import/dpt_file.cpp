#include "datasets/import/dpt_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"

namespace warplut {

static_assert(std::endian::native == std::endian::little, "bytes are copied as they are");

Image ReadDpt(const std::filesystem::path& path) {
  const std::string bytes = ReadFile(path);
  constexpr std::size_t kHeader = 12;
  const auto refuse = [&](const std::string& reason) {
    throw Error(fmt::format("cannot read the depth '{}': {}", path.string(), reason));
  };
  if (bytes.size() < kHeader || bytes.compare(0, 4, "PIEH") != 0) {
    refuse("it does not begin with PIEH; expected a .dpt file");
  }
  std::int32_t size[2];
  std::memcpy(size, bytes.data() + 4, sizeof size);
  for (const std::int32_t side : size) {
    if (side < 1 || side > kMaxImageSide) {
      refuse(fmt::format("a side is {}; expected 1 to {}", side, kMaxImageSide));
    }
  }
  Image depth(size[0], size[1], 1);
  const std::size_t expected = kHeader + depth.data.size() * sizeof(float);
  if (bytes.size() != expected) {
    refuse(fmt::format("it has {} bytes; expected {} for {} x {} pixels", bytes.size(), expected,
                       size[0], size[1]));
  }
  std::memcpy(depth.data.data(), bytes.data() + kHeader, depth.data.size() * sizeof(float));
  return depth;
}

}  // namespace warplut
