// Bytes of files, in little-endian order whatever the machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace warplut {

template <class T>
std::string Bytes(T value) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes += static_cast<char>((value >> (8 * i)) & 0xFF);
  }
  return bytes;
}

inline std::string Bytes32(std::size_t value) { return Bytes(static_cast<std::uint32_t>(value)); }
inline std::string Bytes64(std::size_t value) { return Bytes(static_cast<std::uint64_t>(value)); }
inline std::string BytesOf(float value) { return Bytes(std::bit_cast<std::uint32_t>(value)); }

// Zeros after `size` bytes, up to a multiple of `alignment`.
inline std::string PaddingTo(std::size_t alignment, std::size_t size) {
  return std::string((alignment - size % alignment) % alignment, '\0');
}

}  // namespace warplut
