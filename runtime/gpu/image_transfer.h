// Frames to and from the buffers that images are copied from and to. Rows there follow each other
// without padding.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/gpu/vulkan_resources.h"
#include "runtime/image_view.h"

namespace warplut {

// A channel of B10G11R11_UFLOAT_PACK32: the nearest number with 5 bits of exponent and
// `mantissa_bits` (6 or 5) of mantissa, halves to the greater. Negative numbers and NaN give 0,
// numbers beyond the largest infinity.
std::uint32_t UnsignedFloat(float value, int mantissa_bits);
// And back.
float FromUnsignedFloat(std::uint32_t bits, int mantissa_bits);

// Colours of RGBA8, RGBA16F or RGBA32F as texels of a format that InputConventions lists.
void PackColor(const ImageView& color, VkFormat format, std::byte* to);
// Depth as R32_SFLOAT.
void PackDepth(const ImageView& depth, std::byte* to);
// Motion as R32G32_SFLOAT or R16G16_SFLOAT.
void PackMotion(const MotionView& motion, VkFormat format, std::byte* to);

// Texels of RGBA16F or RGBA32F as an image.
void UnpackColor(const std::byte* from, PixelFormat format, const MutableImageView& out);
// Texels of R32_SFLOAT as depth.
void UnpackDepth(const std::byte* from, const MutableImageView& out);
// The first two channels of texels of R32G32B32A32_SFLOAT as motion.
void UnpackMotion(const std::byte* from, const MutableMotionView& out);

}  // namespace warplut
