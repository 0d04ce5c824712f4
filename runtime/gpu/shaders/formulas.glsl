// What all passes share: options, tests of numbers, codes of colours, gates, weights of filters.
//
// Numbers and enumerators come from the C++ headers (constants.glsl is written by
// runtime/gpu/shader_constants.cpp).
#include "constants.glsl"

// The measure of depth (runtime/gates.h) and the meaning of colour (runtime/color_encoding.h).
layout(constant_id = 2) const int DEPTH = kDepthMeasureRelative;
layout(constant_id = 5) const int ENCODING = kColorEncodingDisplay;
// The filter that warps (runtime/warp.h).
layout(constant_id = 7) const int FILTER = kFilterLut;
layout(constant_id = 8) const int LOOKUP = kLookupBilinear;
layout(constant_id = 9) const bool PREFILTERED = true;
layout(constant_id = 10) const int LAYERS = 4;  // groups of four taps of the table
// Depth as the renderer has it: linear (a z), or a depth buffer: 1 / (a + b z).
layout(constant_id = 11) const bool DEPTH_BUFFER = false;

bool IsFinite(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) < 0x7F800000u; }
bool IsNan(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u; }

// runtime/color_encoding.h.
float HdrCode(float x) {
  int bits = floatBitsToInt(kHdrGain * x + 1.0) - kOneBits;
  float octave = float(bits >> kMantissaBits);
  float f = intBitsToFloat((bits & ((1 << kMantissaBits) - 1)) | kOneBits) - 1.0;
  return (octave + f * (4.0 - f) * (1.0 / 3.0)) * (1.0 / float(kHdrOctaves));
}

float HdrValue(float code) {
  float logarithm = code * float(kHdrOctaves);
  int octave = int(logarithm);
  float f = 2.0 - sqrt(max(4.0 - 3.0 * (logarithm - float(octave)), 0.0));
  int bits = floatBitsToInt(1.0 + f) + (octave << kMantissaBits);
  return min((intBitsToFloat(bits) - 1.0) * (1.0 / kHdrGain), kLargestHdr);
}

float EncodeChannel(float x) {
  if (ENCODING == kColorEncodingLinearHdr) {
    return HdrCode(x > 0.0 && !IsNan(x) ? min(x, kLargestHdr) : 0.0);
  }
  return IsFinite(x) ? clamp(x, 0.0, 1.0) : 0.0;
}

vec3 EncodeColor(vec3 color) {
  return vec3(EncodeChannel(color.r), EncodeChannel(color.g), EncodeChannel(color.b));
}

vec3 DecodeColor(vec3 code) {
  if (ENCODING != kColorEncodingLinearHdr) return code;
  return vec3(HdrValue(code.r), HdrValue(code.g), HdrValue(code.b));
}

// Depth as the passes compare it, in units of the far plane; never -0.
float CleanDepth(float z, float a, float b) {
  float depth = DEPTH_BUFFER ? 1.0 / (a + b * z) : a * z;
  return !IsNan(depth) && depth >= 0.0 && depth < kFarthestDepth ? abs(depth) : kFarthestDepth;
}

// runtime/gates.h.
float Gate(float x, float threshold, float width) {
  float ramp = threshold * width;
  if (!(ramp > 0.0)) return x <= threshold ? 1.0 : 0.0;
  return clamp((threshold + ramp - x) / (ramp + ramp), 0.0, 1.0);
}

float DepthDifference(float a, float b) {
  if (DEPTH == kDepthMeasureNone) return 0.0;
  if (DEPTH == kDepthMeasureAbsolute) return a - b;
  return (a - b) / max(min(a, b), 1e-12);
}

// The weights of the taps -1 to 2 (luts/filters.h).
vec4 KeysTaps(float a, float d) {
  float e = 1.0 - d;
  float outer0 = a * d * e * e;
  float outer3 = a * e * d * d;
  float inner1 = ((a + 2.0) * d - (a + 3.0)) * d * d + 1.0;
  return vec4(outer0, inner1, 1.0 - inner1 - outer0 - outer3, outer3);
}
