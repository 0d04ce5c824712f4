// The format: "Portable Network Graphics (PNG) Specification (Third Edition)", W3C, 2025.
#include "tools/view/flip_picture.h"

#include <cstdint>
#include <vector>

#include "datasets/error.h"
#include "datasets/images/png_chunks.h"

namespace warplut {
namespace {

struct Chunk {
  std::string_view type, data;
};

void Append32(std::uint32_t value, std::string& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
}

void Append16(std::uint32_t value, std::string& bytes) {
  for (int shift = 8; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
}

void AppendChunk(std::string_view type, std::string_view data, std::string& bytes) {
  Append32(static_cast<std::uint32_t>(data.size()), bytes);
  const std::size_t begin = bytes.size();
  bytes += type;
  bytes += data;
  Append32(PngChecksum(std::string_view(bytes).substr(begin)), bytes);
}

std::vector<Chunk> ChunksOf(std::string_view png) {
  const auto damaged = [] {
    throw Error("a picture to flip is no PNG file; expected a whole one");
  };
  if (!png.starts_with(kPngSignature)) damaged();
  std::vector<Chunk> chunks;
  constexpr std::size_t kAround = 12;  // length, type and CRC
  for (std::size_t at = kPngSignature.size(); at < png.size();) {
    if (png.size() - at < kAround) damaged();
    const std::size_t length = PngNumber(png.substr(at));
    if (png.size() - at - kAround < length) damaged();
    chunks.push_back({.type = png.substr(at + 4, 4), .data = png.substr(at + 8, length)});
    at += kAround + length;
  }
  if (chunks.size() < 3 || chunks.front().type != "IHDR" || chunks.back().type != "IEND") damaged();
  return chunks;
}

// The fcTL chunk of a frame that covers the picture.
void AppendControl(std::uint32_t sequence, std::string_view header, int milliseconds,
                   std::string& bytes) {
  std::string data;
  Append32(sequence, data);
  data += header.substr(0, 8);  // width, height
  Append32(0, data);            // offsets
  Append32(0, data);
  Append16(static_cast<std::uint32_t>(milliseconds), data);
  Append16(1000, data);
  data += '\0';  // dispose: none
  data += '\0';  // blend: source
  AppendChunk("fcTL", data, bytes);
}

}  // namespace

std::string FlipPicture(std::string_view first, std::string_view second, int milliseconds) {
  const std::vector<Chunk> a = ChunksOf(first), b = ChunksOf(second);
  if (a.front().data != b.front().data) {
    throw Error("two pictures to flip differ in size or type; expected the same");
  }
  std::string bytes(kPngSignature), animation;
  std::uint32_t sequence = 0;
  AppendChunk("IHDR", a.front().data, bytes);
  Append32(2, animation);  // frames
  Append32(0, animation);  // without end
  AppendChunk("acTL", animation, bytes);
  AppendControl(sequence++, a.front().data, milliseconds, bytes);
  for (std::size_t i = 1; i + 1 < a.size(); ++i) AppendChunk(a[i].type, a[i].data, bytes);
  AppendControl(sequence++, a.front().data, milliseconds, bytes);
  for (const Chunk& chunk : b) {
    if (chunk.type != "IDAT") continue;
    std::string data;
    Append32(sequence++, data);
    data += chunk.data;
    AppendChunk("fdAT", data, bytes);
  }
  AppendChunk("IEND", "", bytes);
  return bytes;
}

}  // namespace warplut
