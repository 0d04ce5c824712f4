// A table as shader source: its weights, its prefilter and a sampling function, in one file that
// needs no other.
#pragma once

#include <cstdint>
#include <string>

#include "luts/table.h"

namespace warplut {

enum class ShaderLanguage : std::uint8_t { kGlsl, kHlsl };

// Whether a table can be source: 16 taps. Others are textures alone (table_texture.h).
constexpr bool HasShaderSource(Footprint footprint) { return footprint == Footprint::k16; }

// The text of NAME.glsl (GLSL 4.30 or later, also for Vulkan; ESSL 3.10 or later) or NAME.hlsl
// (shader model 5 or later). `banner` are comment lines. The table has 16 taps and weights that are
// halves; the source holds the eighth of its nodes that the symmetries of the square leave, and an
// Error names `name` if the table lacks them.
//
// Some compilers take long over the array of nodes: lavapipe of Mesa 22.3 needs eight seconds.
// Where the macro warplut_TABLE names an array texture before the source (texelFetch takes it; in
// HLSL a Texture2DArray), nodes come from it and there is no array. NAME.ktx2 and NAME.dds are its
// files.
//
//   mat4 warplut_weights(vec2 offset)           bilinear lookup: element [ky][kx] is the weight
//   mat4 warplut_nearest_weights(vec2 offset)   of tap (kx - 1, ky - 1); offset in [0, 1)^2
//   vec4 warplut_sample(image, size, position)  the image at `position`, in texels, the centre of
//                                               the first at (1/2, 1/2); with a prefilter `image`
//                                               holds coefficients
//   vec4 warplut_prefilter(image, size, texel, axis)   one pass of the prefilter along an axis,
//                                               (1, 0) or (0, 1), as the sum of its taps; a
//                                               recursion is cut where the rest is less than
//                                               kShaderPrefilterRest
std::string ShaderSource(const std::string& name, const std::string& banner, const Table& table,
                         ShaderLanguage language);

// The sum of the taps of a recursive prefilter that are left out, relative to their sum.
inline constexpr double kShaderPrefilterRest = 0x1p-16;

}  // namespace warplut
