#include "runtime/gpu/image_transfer.h"

#include <cstring>

#include "luts/half.h"
#include "runtime/core/pixel.h"
#include "runtime/sr/render_planes.h"

namespace warplut {
namespace {

constexpr int kHalfMantissaBits = 10;

// The texel of `color`, four channels, at `to`.
void PackTexel(const float (&color)[4], TexelFormat format, std::byte* to) {
  if (format == TexelFormat::kR11G11B10F) {
    const std::uint32_t texel = UnsignedFloat(color[0], 6) | UnsignedFloat(color[1], 6) << 11 |
                                UnsignedFloat(color[2], 5) << 22;
    std::memcpy(to, &texel, sizeof(texel));
    return;
  }
  const PixelFormat pixel = format == TexelFormat::kRgba8     ? PixelFormat::kRgba8
                            : format == TexelFormat::kRgba16F ? PixelFormat::kRgba16F
                                                              : PixelFormat::kRgba32F;
  for (int c = 0; c < 4; ++c) StoreChannel(pixel, color[c] * ChannelScale(pixel), to, c);
}

}  // namespace

// A half without sign has the same exponent and more bits of mantissa.
std::uint32_t UnsignedFloat(float value, int mantissa_bits) {
  if (IsNan(value) || value <= 0) return 0;
  const int dropped = kHalfMantissaBits - mantissa_bits;
  return (std::uint32_t{FloatToHalf(value)} + (1u << (dropped - 1))) >> dropped;
}

float FromUnsignedFloat(std::uint32_t bits, int mantissa_bits) {
  return HalfToFloat(static_cast<std::uint16_t>(bits << (kHalfMantissaBits - mantissa_bits)));
}

void PackColor(const ImageView& color, TexelFormat format, std::byte* to) {
  const float unit = ChannelScale(color.format);
  for (int y = 0; y < color.height; ++y) {
    for (int x = 0; x < color.width; ++x, to += TexelBytes(format)) {
      float channels[4];
      for (int c = 0; c < 4; ++c) channels[c] = LoadChannel(color.format, color.At(x, y), c) / unit;
      PackTexel(channels, format, to);
    }
  }
}

void PackDepth(const ImageView& depth, std::byte* to) {
  const std::size_t row = static_cast<std::size_t>(depth.width) * sizeof(float);
  for (int y = 0; y < depth.height; ++y, to += row) std::memcpy(to, depth.Row<float>(y), row);
}

void PackMotion(const MotionView& motion, TexelFormat format, std::byte* to) {
  const int count = 2 * motion.width;
  for (int y = 0; y < motion.height; ++y) {
    const float* from = motion.Row(y);
    for (int i = 0; i < count; ++i) {
      if (format == TexelFormat::kRg16F) {
        const std::uint16_t half = FloatToHalf(from[i]);
        std::memcpy(to, &half, sizeof(half));
        to += sizeof(half);
      } else {
        std::memcpy(to, from + i, sizeof(float));
        to += sizeof(float);
      }
    }
  }
}

void PackReactive(const ImageView& mask, TexelFormat format, std::byte* to) {
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x, to += TexelBytes(format)) {
      const float value = mask.Row<float>(y)[x];
      if (format == TexelFormat::kR8) {
        *to = static_cast<std::byte>(SanitizeReactive(value) * 255 + 0.5f);
      } else if (format == TexelFormat::kR16F) {
        const std::uint16_t half = FloatToHalf(value);
        std::memcpy(to, &half, sizeof(half));
      } else {
        std::memcpy(to, &value, sizeof(value));
      }
    }
  }
}

void UnpackColor(const std::byte* from, PixelFormat format, const MutableImageView& out) {
  const float scale = ChannelScale(out.format);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x, from += BytesPerPixel(format)) {
      for (int c = 0; c < 4; ++c)
        StoreChannel(out.format, LoadChannel(format, from, c) * scale, out.At(x, y), c);
    }
  }
}

void UnpackDepth(const std::byte* from, const MutableImageView& out) {
  const std::size_t row = static_cast<std::size_t>(out.width) * sizeof(float);
  for (int y = 0; y < out.height; ++y, from += row) std::memcpy(out.Row<float>(y), from, row);
}

void UnpackMotion(const std::byte* from, const MutableMotionView& out) {
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x, from += 4 * sizeof(float))
      std::memcpy(out.Row(y) + 2 * x, from, 2 * sizeof(float));
  }
}

}  // namespace warplut
