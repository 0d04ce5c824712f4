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

constexpr std::size_t kPiece = std::size_t{1} << 16;  // bytes that are read at once

using Word = std::array<char, 4>;

std::string_view View(const Word& word) { return {word.data(), word.size()}; }

// The checksum of `type` and the `length` bytes that follow; nothing if the file ends.
std::optional<std::uint32_t> ReadChecksum(std::istream& file, const Word& type,
                                          std::uint32_t length) {
  std::uint32_t sum = PngChecksum(View(type));
  std::array<char, kPiece> piece;
  for (std::uint32_t left = length; left > 0;) {
    const std::size_t count = std::min<std::size_t>(left, piece.size());
    if (!file.read(piece.data(), static_cast<std::streamsize>(count))) return std::nullopt;
    sum = PngChecksum(std::string_view(piece.data(), count), sum);
    left -= static_cast<std::uint32_t>(count);
  }
  return sum;
}

}  // namespace

std::uint32_t PngNumber(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(0, 4)) {
    number = number << 8 | static_cast<unsigned char>(byte);
  }
  return number;
}

std::uint32_t PngChecksum(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void CheckPngChunks(const std::filesystem::path& path, bool pixels) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, kPngSignature.size()> start;
  if (!file.read(start.data(), start.size()) ||
      std::string_view(start.data(), start.size()) != kPngSignature) {
    return;
  }
  const std::uintmax_t size = std::filesystem::file_size(path);
  for (Word length_word, type, checksum;;) {
    if (!file.read(length_word.data(), length_word.size()) ||
        !file.read(type.data(), type.size())) {
      RefuseImage(path, "it is cut off; expected a chunk IEND at its end");
    }
    if (!pixels && View(type) == "IDAT") return;
    const std::uint32_t length = PngNumber(View(length_word));
    const auto at = static_cast<std::uintmax_t>(file.tellg());
    if (at + length + checksum.size() > size) {
      RefuseImage(path, fmt::format("it is cut off after {} bytes; expected {} more in a chunk",
                                    size, at + length + checksum.size() - size));
    }
    const auto found = ReadChecksum(file, type, length);
    if (!found || !file.read(checksum.data(), checksum.size()) ||
        *found != PngNumber(View(checksum))) {
      RefuseImage(path, "it is damaged: a chunk's checksum does not fit");
    }
    if (View(type) == "IEND") return;
  }
}

}  // namespace warplut
