#include "datasets/images/exr_header.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/images/image_io.h"
#include "datasets/images/image_message.h"

namespace warplut {
namespace {

constexpr std::uint32_t kExrMagic = 20000630;
constexpr std::uint32_t kMultiPart = 0x1000;  // in the version
constexpr std::size_t kLongestName = 255;
constexpr std::uint32_t kMaxTileSide = 4096;
constexpr std::uint32_t kBytesOfChannel = 16;  // after its name

// Types of attributes with one length. Libraries read that many bytes, whatever the file tells.
constexpr std::pair<std::string_view, std::uint32_t> kFixedLengths[] = {
    {"box2f", 16},      {"box2i", 16},    {"chromaticities", 32},
    {"compression", 1}, {"double", 8},    {"deepImageState", 1},
    {"envmap", 1},      {"float", 4},     {"int", 4},
    {"keycode", 28},    {"lineOrder", 1}, {"m33d", 72},
    {"m33f", 36},       {"m44d", 128},    {"m44f", 64},
    {"rational", 8},    {"tiledesc", 9},  {"timecode", 8},
    {"v2d", 16},        {"v2f", 8},       {"v2i", 8},
    {"v3d", 24},        {"v3f", 12},      {"v3i", 12}};

// Little-endian.
bool ReadNumber(std::istream& file, std::uint32_t* number) {
  unsigned char bytes[4];
  if (!file.read(reinterpret_cast<char*>(bytes), sizeof(bytes))) return false;
  *number = 0;
  for (int i = 3; i >= 0; --i) *number = *number << 8 | bytes[i];
  return true;
}

// A text that ends with a zero; false at the end of the file, or if it is longer than names are.
bool ReadName(std::istream& file, std::string* name) {
  name->clear();
  for (int c; (c = file.get()) != std::char_traits<char>::eof();) {
    if (c == 0) return true;
    *name += static_cast<char>(c);
    if (name->size() > kLongestName) return false;
  }
  return false;
}

// The length of a list of channels that begins here: names with 16 bytes each, and an empty name.
std::uint32_t ChannelListLength(std::istream& file) {
  std::uint32_t length = 0;
  for (std::string name; ReadName(file, &name);) {
    length += static_cast<std::uint32_t>(name.size()) + 1;
    if (name.empty()) return length;
    length += kBytesOfChannel;
    file.seekg(kBytesOfChannel, std::ios::cur);
  }
  return 0;
}

// Sides of the window that begins here: readers take memory for lines of that length.
void CheckWindow(const std::filesystem::path& path, std::istream& file) {
  std::uint32_t corners[4] = {};  // least x, least y, largest x, largest y
  for (std::uint32_t& corner : corners) ReadNumber(file, &corner);
  const auto side = [&](int axis) {
    return std::int64_t{static_cast<std::int32_t>(corners[axis + 2])} -
           static_cast<std::int32_t>(corners[axis]) + 1;
  };
  const std::int64_t width = side(0), height = side(1);
  if (width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide) return;
  RefuseImage(path, fmt::format("its size is {} x {}; expected sides from 1 to {}", width, height,
                                kMaxImageSide));
}

void CheckTiles(const std::filesystem::path& path, std::istream& file) {
  std::uint32_t width = 0, height = 0;
  ReadNumber(file, &width);
  ReadNumber(file, &height);
  if (width <= kMaxTileSide && height <= kMaxTileSide) return;
  RefuseImage(path, fmt::format("its tiles are {} x {}; expected sides of at most {}", width,
                                height, kMaxTileSide));
}

// The only length that the attribute at this place can have; nothing if it can have any.
std::optional<std::uint32_t> LengthOf(std::istream& file, std::string_view type) {
  if (type == "chlist") {
    const auto place = file.tellg();
    const std::uint32_t length = ChannelListLength(file);
    file.clear();
    file.seekg(place);
    return length;
  }
  for (const auto& [name, length] : kFixedLengths) {
    if (type == name) return length;
  }
  return std::nullopt;
}

}  // namespace

void CheckExrHeader(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::uint32_t magic = 0, version = 0;
  if (!ReadNumber(file, &magic) || magic != kExrMagic || !ReadNumber(file, &version)) return;
  const std::uintmax_t length = std::filesystem::file_size(path);
  bool in_header = false;  // an empty name ends a header, and an empty header those of all parts
  for (std::string name, type; ReadName(file, &name);) {
    if (name.empty()) {
      if (!in_header || (version & kMultiPart) == 0) return;
      in_header = false;
      continue;
    }
    in_header = true;
    std::uint32_t size = 0;
    if (!ReadName(file, &type) || !ReadNumber(file, &size)) return;
    const std::optional<std::uint32_t> expected = LengthOf(file, type);
    if (size > length || (expected && size != *expected)) {
      RefuseImage(
          path, fmt::format("an attribute of its header, of type '{}', tells a length of {} bytes; "
                            "expected {}",
                            type, size,
                            expected ? std::to_string(*expected)
                                     : fmt::format("at most the {} bytes of the file", length)));
    }
    const auto place = file.tellg();
    if (name == "dataWindow" || name == "displayWindow") CheckWindow(path, file);
    if (type == "tiledesc") CheckTiles(path, file);
    file.clear();
    file.seekg(place);
    file.seekg(size, std::ios::cur);
  }
}

}  // namespace warplut
