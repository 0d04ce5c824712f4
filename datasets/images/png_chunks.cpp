#include "datasets/images/png_chunks.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

#include "datasets/images/image_message.h"

namespace warplut {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kPiece = std::size_t{1} << 16;  // bytes that are read at once

using Word = std::array<char, 4>;

// Big-endian.
std::uint32_t ToNumber(const Word& word) {
  std::uint32_t number = 0;
  for (const char byte : word) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

// The checksum of `type` and the `length` bytes that follow; nothing if the file ends.
std::optional<std::uint32_t> ReadChecksum(std::istream& file, const Word& type,
                                          std::uint32_t length) {
  uLong sum = crc32(0, reinterpret_cast<const Bytef*>(type.data()), type.size());
  std::array<char, kPiece> piece;
  for (std::uint32_t left = length; left > 0;) {
    const std::size_t count = std::min<std::size_t>(left, piece.size());
    if (!file.read(piece.data(), static_cast<std::streamsize>(count))) return std::nullopt;
    sum = crc32(sum, reinterpret_cast<const Bytef*>(piece.data()), static_cast<uInt>(count));
    left -= static_cast<std::uint32_t>(count);
  }
  return static_cast<std::uint32_t>(sum);
}

}  // namespace

void CheckPngChunks(const std::filesystem::path& path, bool pixels) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, kSignature.size()> start;
  if (!file.read(start.data(), start.size()) ||
      std::string_view(start.data(), start.size()) != kSignature) {
    return;
  }
  const std::uintmax_t size = std::filesystem::file_size(path);
  bool seen_pixels = false;
  for (Word length_word, type, checksum;;) {
    if (!file.read(length_word.data(), length_word.size()) ||
        !file.read(type.data(), type.size())) {
      RefuseImage(path, "it is cut off; expected a chunk IEND at its end");
    }
    const std::string_view name(type.data(), type.size());
    const std::uint32_t length = ToNumber(length_word);
    const auto at = static_cast<std::uintmax_t>(file.tellg());
    if (at + length + checksum.size() > size) {
      RefuseImage(path, fmt::format("it is cut off after {} bytes; expected {} more in a chunk",
                                    size, at + length + checksum.size() - size));
    }
    seen_pixels = seen_pixels || name == "IDAT";
    if (seen_pixels && !pixels) {
      file.seekg(length + checksum.size(), std::ios::cur);
    } else {
      const auto found = ReadChecksum(file, type, length);
      if (!found || !file.read(checksum.data(), checksum.size()) || *found != ToNumber(checksum)) {
        RefuseImage(path, "it is damaged: a chunk's checksum does not fit");
      }
    }
    if (name == "IEND") return;
  }
}

}  // namespace warplut
