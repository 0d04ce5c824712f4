// The chunks of a PNG file. Source: "Portable Network Graphics Specification (Third Edition)",
// section 5.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace warplut {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// The number in the first four bytes, the most significant one first.
std::uint32_t PngNumber(std::string_view bytes);

// The checksum of bytes that follow those of the checksum `before`; 0: of none.
std::uint32_t PngChecksum(std::string_view bytes, std::uint32_t before = 0);

// An Error that names the file where a chunk goes beyond its end, the last one is not IEND, or a
// checksum does not fit: libraries tell that on standard error besides. Without `pixels` the chunks
// before the first pixel are checked, and no others are read. Files that do not begin as PNG are
// left to the reader.
void CheckPngChunks(const std::filesystem::path& path, bool pixels);

}  // namespace warplut
