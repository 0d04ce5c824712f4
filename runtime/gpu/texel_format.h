// Formats of the images on a GPU, in the words of no API.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/image_view.h"

namespace warplut {

// Channels in their order in memory; kR11G11B10F has red in the lowest bits of a 32-bit word.
enum class TexelFormat : std::uint8_t {
  kR8,
  kR16F,
  kR32F,
  kRg16F,
  kRg32F,
  kRgba8,
  kRgba16F,
  kRgba32F,
  kR11G11B10F
};
inline constexpr int kTexelFormats = 9;

// Bytes of a texel.
std::size_t TexelBytes(TexelFormat format);

// As it is written in messages: "r11g11b10f".
const char* Name(TexelFormat format);

// That of kRgba16F or kRgba32F.
constexpr TexelFormat TexelFormatOf(PixelFormat format) {
  return format == PixelFormat::kRgba16F ? TexelFormat::kRgba16F : TexelFormat::kRgba32F;
}

// Whether shaders store to images of this format. Others are inputs.
constexpr bool IsStored(TexelFormat format) {
  return format == TexelFormat::kR32F || format == TexelFormat::kRgba16F ||
         format == TexelFormat::kRgba32F;
}

}  // namespace warplut
