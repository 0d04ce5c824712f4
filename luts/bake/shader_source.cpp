#include "luts/bake/shader_source.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "datasets/error.h"

namespace warplut {
namespace {

constexpr int kHalf = kNodes / 2;

// The rows that the source stores: nodes (i, j) with 0 <= j <= i <= kHalf.
constexpr int StoredRow(int i, int j) { return i * (i + 1) / 2 + j; }
constexpr int kStoredRows = StoredRow(kHalf, kHalf) + 1;

float WeightOf(const Table& table, int ix, int jy, int k) {
  return table.data()[(jy * kTableNodes + ix) * RowFloats(Footprint::k16) + k];
}

// Whether each node has the weights that the source finds by the symmetries.
bool IsSymmetric(const Table& table) {
  for (int jy = 0; jy < kTableNodes; ++jy) {
    for (int ix = 0; ix < kTableNodes; ++ix) {
      const bool flips_x = ix > kHalf, flips_y = jy > kHalf;
      const int i = flips_x ? kNodes - ix : ix, j = flips_y ? kNodes - jy : jy;
      for (int k = 0; k < kTaps * kTaps; ++k) {
        int kx = k % kTaps, ky = k / kTaps;
        if (flips_x) kx = kTaps - 1 - kx;
        if (flips_y) ky = kTaps - 1 - ky;
        const float stored = i >= j ? WeightOf(table, i, j, ky * kTaps + kx)
                                    : WeightOf(table, j, i, kx * kTaps + ky);
        if (WeightOf(table, ix, jy, k) != stored) return false;
      }
    }
  }
  return true;
}

// Values between braces or parentheses, two a line.
std::string Listed(const std::vector<std::string>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i % 2 == 0 ? "\n  " : " ") + values[i] + (i + 1 < values.size() ? "," : "");
  }
  return text;
}

// In GLSL a variable: of a constant, compilers make a copy at each place that reads it.
std::string ArrayOf(ShaderLanguage language, std::string_view type, std::string_view name,
                    const std::vector<std::string>& values) {
  const bool hlsl = language == ShaderLanguage::kHlsl;
  return fmt::format("{0}{1} {2}[{3}] = {4}{5}{6};\n", hlsl ? "static const " : "", type, name,
                     values.size(), hlsl ? "{" : fmt::format("{}[{}](", type, values.size()),
                     Listed(values), hlsl ? "}" : ")");
}

// Two vectors of four words a row, two halves a word.
std::vector<std::string> PackedRows(const Table& table) {
  std::vector<std::string> vectors;
  for (int i = 0; i <= kHalf; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (int half_row = 0; half_row < 2; ++half_row) {
        std::array<std::uint32_t, 4> words{};
        for (int k = 0; k < 8; ++k) {
          const std::uint32_t bits = FloatToHalf(WeightOf(table, i, j, 8 * half_row + k));
          words[static_cast<std::size_t>(k / 2)] |= bits << (16 * (k % 2));
        }
        vectors.push_back(fmt::format("uvec4({:#010x}u, {:#010x}u, {:#010x}u, {:#010x}u)", words[0],
                                      words[1], words[2], words[3]));
      }
    }
  }
  return vectors;
}

// The taps of one axis of the prefilter, from the middle to one side; of a recursion those of its
// impulse response, scaled so that all sum to 1.
std::vector<double> PrefilterTaps(const Prefilter& prefilter) {
  std::vector<double> taps;
  if (prefilter.kind == PrefilterKind::kFir) {
    double middle = 1;
    for (int j = 1; j <= prefilter.reach; ++j) middle -= 2 * static_cast<double>(prefilter.taps[j]);
    taps.push_back(middle);
    for (int j = 1; j <= prefilter.reach; ++j)
      taps.push_back(static_cast<double>(prefilter.taps[j]));
    return taps;
  }
  const double z = PoleOfSide(static_cast<double>(prefilter.side));
  double power = 1, rest = 1, sum = 0;
  while (rest > kShaderPrefilterRest * (1 - std::abs(z)) / 2) {
    taps.push_back(power);
    sum += (taps.size() == 1 ? 1 : 2) * power;
    power *= z;
    rest = std::abs(power);
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

constexpr std::string_view kGlslWords = R"(#define WARPLUT_IMAGE sampler2D
#define WARPLUT_FETCH(image, texel) texelFetch(image, texel, 0)
#define WARPLUT_FETCH_LAYER(image, texel, layer) texelFetch(image, ivec3(texel, layer), 0)
#define WARPLUT_HALVES(word) unpackHalf2x16(word)
)";
constexpr std::string_view kHlslWords = R"(#define WARPLUT_IMAGE Texture2D<float4>
#define WARPLUT_FETCH(image, texel) image.Load(int3(texel, 0))
#define WARPLUT_FETCH_LAYER(image, texel, layer) image.Load(int4(texel, layer, 0))
#define WARPLUT_HALVES(word) f16tof32(uint2(word, (word) >> 16))
#define vec2 float2
#define vec4 float4
#define mat4 float4x4
#define ivec2 int2
#define uvec4 uint4
)";
constexpr std::string_view kHlslEnd = R"(
#undef vec2
#undef vec4
#undef mat4
#undef ivec2
#undef uvec4
)";

// The same of an array texture that the program defines.
constexpr std::string_view kNodeOfTexture = R"(
// The weights of node (ix, jy), 0 to @NODES@ in each axis, from the texture: the array's file is
// @NAME@.ktx2 or @NAME@.dds.
mat4 @NAME@_node(int ix, int jy) {
  ivec2 node = ivec2(ix, jy);
  return mat4(WARPLUT_FETCH_LAYER(@NAME@_TABLE, node, 0),
              WARPLUT_FETCH_LAYER(@NAME@_TABLE, node, 1),
              WARPLUT_FETCH_LAYER(@NAME@_TABLE, node, 2),
              WARPLUT_FETCH_LAYER(@NAME@_TABLE, node, 3));
}
)";

constexpr std::string_view kNodeOfArray = R"(
// The weights of node (ix, jy), 0 to @NODES@ in each axis: element [ky][kx] is the weight of tap
// (kx - 1, ky - 1).
mat4 @NAME@_node(int ix, int jy) {
  bool flips_x = ix > @HALF@;
  bool flips_y = jy > @HALF@;
  int i = flips_x ? @NODES@ - ix : ix;
  int j = flips_y ? @NODES@ - jy : jy;
  int row = j > i ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
  uvec4 upper = @NAME@_rows[2 * row];
  uvec4 lower = @NAME@_rows[2 * row + 1];
  mat4 w;
  w[0] = vec4(WARPLUT_HALVES(upper.x), WARPLUT_HALVES(upper.y));
  w[1] = vec4(WARPLUT_HALVES(upper.z), WARPLUT_HALVES(upper.w));
  w[2] = vec4(WARPLUT_HALVES(lower.x), WARPLUT_HALVES(lower.y));
  w[3] = vec4(WARPLUT_HALVES(lower.z), WARPLUT_HALVES(lower.w));
  if (j > i) w = transpose(w);
  if (flips_x) w = mat4(w[0].wzyx, w[1].wzyx, w[2].wzyx, w[3].wzyx);
  if (flips_y) w = mat4(w[3], w[2], w[1], w[0]);
  return w;
}
)";

constexpr std::string_view kLookup = R"(
// The weights for an offset in [0, 1)^2, bilinear between the nodes around it.
mat4 @NAME@_weights(vec2 offset) {
  vec2 node = floor(offset * @NODES@.0);
  vec2 f = offset * @NODES@.0 - node;
  vec4 zero = vec4(0.0, 0.0, 0.0, 0.0);
  mat4 w = mat4(zero, zero, zero, zero);
  for (int corner = 0; corner < 4; ++corner) {
    int x = corner % 2;
    int y = corner / 2;
    float share = (x == 1 ? f.x : 1.0 - f.x) * (y == 1 ? f.y : 1.0 - f.y);
    w += @NAME@_node(int(node.x) + x, int(node.y) + y) * share;
  }
  return w;
}

// The weights of the nearest node.
mat4 @NAME@_nearest_weights(vec2 offset) {
  return @NAME@_node(int(offset.x * @NODES@.0 + 0.5), int(offset.y * @NODES@.0 + 0.5));
}
)";

constexpr std::string_view kSample = R"(
// The image of `size` texels at `position`: the centre of texel (x, y) is (x + 1/2, y + 1/2).
vec4 @NAME@_sample(WARPLUT_IMAGE image, ivec2 size, vec2 position) {
  vec2 p = @POSITION@;
  vec2 texel = floor(p);
  mat4 w = @NAME@_weights(p - texel);
  ivec2 first = ivec2(texel) - ivec2(1, 1);
  ivec2 last = size - ivec2(1, 1);
  vec4 sum = vec4(0.0, 0.0, 0.0, 0.0);
  for (int ky = 0; ky < 4; ++ky) {
    for (int kx = 0; kx < 4; ++kx) {
      ivec2 tap = clamp(first + ivec2(kx, ky), ivec2(0, 0), last);
      sum += w[ky][kx] * WARPLUT_FETCH(image, tap);
    }
  }
  return sum;
}
)";

constexpr std::string_view kPrefilter = R"(
// The texel that stands for i > -@TAPS@: the image is mirrored at its edges. The remainder of a
// negative number is not defined.
int @NAME@_mirrored(int i, int size) {
  int period = 2 * size;
  int inside = (i + @TAPS@ * period) % period;
  return inside < size ? inside : period - 1 - inside;
}

// One axis, (1, 0) or (0, 1), of the prefilter at a texel. Run it along one axis, then along the
// other.
vec4 @NAME@_prefilter(WARPLUT_IMAGE image, ivec2 size, ivec2 texel, ivec2 axis) {
  vec4 sum = @NAME@_taps[0] * WARPLUT_FETCH(image, texel);
  for (int j = 1; j < @TAPS@; ++j) {
    ivec2 before = texel - j * axis;
    ivec2 after = texel + j * axis;
    before = ivec2(@NAME@_mirrored(before.x, size.x), @NAME@_mirrored(before.y, size.y));
    after = ivec2(@NAME@_mirrored(after.x, size.x), @NAME@_mirrored(after.y, size.y));
    sum += @NAME@_taps[j] * (WARPLUT_FETCH(image, before) + WARPLUT_FETCH(image, after));
  }
  return sum;
}
)";

void ReplaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string ShaderSource(const std::string& name, const std::string& banner, const Table& table,
                         ShaderLanguage language) {
  if (!IsSymmetric(table)) {
    throw Error(name + ": the table lacks the symmetries of the square, expected as in every fit");
  }
  const bool hlsl = language == ShaderLanguage::kHlsl;
  const bool prefiltered = HasPrefilter(table.prefilter());
  std::string text = banner;
  text += "\n#ifndef @NAME@_included\n#define @NAME@_included\n\n";
  text += "#ifndef WARPLUT_IMAGE\n";
  text += hlsl ? kHlslWords.substr(0, kHlslWords.find("#define vec2")) : kGlslWords;
  text += "#endif\n";
  if (hlsl) text += kHlslWords.substr(kHlslWords.find("#define vec2"));
  text += "\n#ifdef @NAME@_TABLE\n";
  text += kNodeOfTexture;
  text += "\n#else\n";
  text += fmt::format(
      "\n// Rows of nodes (i, j) with 0 <= j <= i <= {}, at i (i + 1) / 2 + j; two halves a "
      "word.\n",
      kHalf);
  text += ArrayOf(language, "uvec4", "@NAME@_rows", PackedRows(table));
  text += kNodeOfArray;
  text += "\n#endif\n";
  text += kLookup;
  text += kSample;
  if (prefiltered) {
    std::vector<std::string> taps;
    for (const double tap : PrefilterTaps(table.prefilter()))
      taps.push_back(fmt::format("{:.9f}", tap));
    text += "\n// The taps of the prefilter, from the middle to one side.\n";
    text += ArrayOf(language, "float", "@NAME@_taps", taps);
    text += kPrefilter;
    ReplaceAll(text, "@TAPS@", std::to_string(taps.size()));
  }
  if (hlsl) text += kHlslEnd;
  text += "\n#endif\n";
  ReplaceAll(text, "@POSITION@",
             prefiltered ? "clamp(position - 0.5, vec2(0.0, 0.0), vec2(size - ivec2(1, 1)))"
                         : "position - 0.5");
  ReplaceAll(text, "@NODES@", std::to_string(kNodes));
  ReplaceAll(text, "@HALF@", std::to_string(kHalf));
  ReplaceAll(text, "@NAME@", name);
  static_assert(kStoredRows == 153);
  return text;
}

}  // namespace warplut
