// Frames to and from the buffers that images are copied from and to. Rows there follow each other
// without padding.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/gpu/texel_format.h"
#include "runtime/image_view.h"

namespace warplut {

// A channel of r11g11b10f: the nearest number with 5 bits of exponent and
// `mantissa_bits` (6 or 5) of mantissa, halves to the greater. Negative numbers and NaN give 0,
// numbers beyond the largest infinity.
std::uint32_t UnsignedFloat(float value, int mantissa_bits);
// And back.
float FromUnsignedFloat(std::uint32_t bits, int mantissa_bits);

// Colours of RGBA8, RGBA16F or RGBA32F as texels of a format that InputConventions lists.
void PackColor(const ImageView& color, TexelFormat format, std::byte* to);
// Depth as r32f.
void PackDepth(const ImageView& depth, std::byte* to);
// Motion as rg32f or rg16f.
void PackMotion(const MotionView& motion, TexelFormat format, std::byte* to);
// A reactive mask as r32f, r16f or r8; r8 has [0, 1], and NaN is 0 there.
void PackReactive(const ImageView& mask, TexelFormat format, std::byte* to);

// Texels of RGBA16F or RGBA32F as an image.
void UnpackColor(const std::byte* from, PixelFormat format, const MutableImageView& out);
// Texels of r32f as depth.
void UnpackDepth(const std::byte* from, const MutableImageView& out);
// The first two channels of texels of rgba32f as motion.
void UnpackMotion(const std::byte* from, const MutableMotionView& out);

}  // namespace warplut
