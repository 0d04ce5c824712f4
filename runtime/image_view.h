// Views of pixels that someone else owns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

// Interleaved channels, row 0 at the top. 8-bit codes stand for value / 255; halves are IEEE
// binary16.
enum class PixelFormat : std::uint8_t { kRgba8, kRgba16F, kRgba32F, kR32F };

inline constexpr PixelFormat kPixelFormats[] = {PixelFormat::kRgba8, PixelFormat::kRgba16F,
                                                PixelFormat::kRgba32F, PixelFormat::kR32F};
// Those of colour: of frames, histories and outputs.
inline constexpr PixelFormat kColorFormats[] = {PixelFormat::kRgba8, PixelFormat::kRgba16F,
                                                PixelFormat::kRgba32F};

constexpr const char* Name(PixelFormat format) {
  switch (format) {
    case PixelFormat::kRgba8:
      return "rgba8";
    case PixelFormat::kRgba16F:
      return "rgba16f";
    case PixelFormat::kRgba32F:
      return "rgba32f";
    case PixelFormat::kR32F:
      return "r32f";
  }
  return "";
}

constexpr int Channels(PixelFormat format) { return format == PixelFormat::kR32F ? 1 : 4; }

constexpr int BytesPerPixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::kRgba8:
      return 4;
    case PixelFormat::kRgba16F:
      return 8;
    case PixelFormat::kRgba32F:
      return 16;
    case PixelFormat::kR32F:
      return 4;
  }
  return 0;
}

// `stride` is the distance of rows in bytes; pixels are aligned to the size of a channel.
template <class Void>
struct BasicImageView {
  Void* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;
  PixelFormat format = PixelFormat::kRgba8;

  // The address of pixel (x, y), which must lie in the image.
  Void* At(int x, int y) const {
    return Row<std::byte>(y) + std::ptrdiff_t{x} * BytesPerPixel(format);
  }

  // Row y as channels of type T.
  template <class T>
  auto* Row(int y) const {
    if constexpr (std::is_const_v<Void>) {
      return reinterpret_cast<const T*>(static_cast<const std::byte*>(data) + y * stride);
    } else {
      return reinterpret_cast<T*>(static_cast<std::byte*>(data) + y * stride);
    }
  }

  operator BasicImageView<const void>() const requires(!std::is_const_v<Void>) {
    return {data, width, height, stride, format};
  }
};

using ImageView = BasicImageView<const void>;
using MutableImageView = BasicImageView<void>;

// Motion vectors (x, y) in pixels, interleaved; `stride` in bytes, floats aligned to 4 bytes.
template <class Float>
struct BasicMotionView {
  Float* xy = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  Float* Row(int y) const {
    using Byte = std::conditional_t<std::is_const_v<Float>, const std::byte, std::byte>;
    return reinterpret_cast<Float*>(reinterpret_cast<Byte*>(xy) + y * stride);
  }

  operator BasicMotionView<const Float>() const requires(!std::is_const_v<Float>) {
    return {xy, width, height, stride};
  }
};

using MotionView = BasicMotionView<const float>;
using MutableMotionView = BasicMotionView<float>;

}  // namespace warplut
