#include "runtime/gpu/texel_format.h"

namespace warplut {
namespace {

struct FormatInfo {
  const char* name;
  std::size_t bytes;
};
// In the order of the enumerators.
constexpr FormatInfo kFormats[kTexelFormats] = {{"r8", 1},      {"r16f", 2},     {"r32f", 4},
                                                {"rg16f", 4},   {"rg32f", 8},    {"rgba8", 4},
                                                {"rgba16f", 8}, {"rgba32f", 16}, {"r11g11b10f", 4}};

}  // namespace

std::size_t TexelBytes(TexelFormat format) {
  return kFormats[static_cast<std::size_t>(format)].bytes;
}

const char* Name(TexelFormat format) { return kFormats[static_cast<std::size_t>(format)].name; }

}  // namespace warplut
