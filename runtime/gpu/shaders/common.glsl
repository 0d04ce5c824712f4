// What the passes share: options, numbers of the frame, positions on both grids, colours, gates.
//
// Numbers and enumerators come from the C++ headers (constants.glsl is written by
// runtime/gpu/shader_constants.cpp). Formulas follow runtime/sr/reference.h line by line; tests
// compare every pass with it.
#include "constants.glsl"

// Choices of SuperResolutionOptions, as in runtime/choices.h.
layout(constant_id = 0) const int FORM = kHistoryFormAdaptive;
layout(constant_id = 1) const int CLAMP = kColorClampVariance;
layout(constant_id = 2) const int DEPTH = kDepthMeasureRelative;
layout(constant_id = 3) const int MOTION = kMotionUpsamplingEdgeAware;
layout(constant_id = 4) const int CURRENT = kCurrentFrameBilinear;
layout(constant_id = 5) const int ENCODING = kColorEncodingDisplay;
layout(constant_id = 6) const bool HISTORY = true;
// The filter of the history (runtime/warp.h).
layout(constant_id = 7) const int FILTER = kFilterLut;
layout(constant_id = 8) const int LOOKUP = kLookupBilinear;
layout(constant_id = 9) const bool PREFILTERED = true;
layout(constant_id = 10) const int LAYERS = 4;  // groups of four taps of the table
// Depth as the renderer has it: linear (depth_a z), or a depth buffer: 1 / (depth_a + depth_b z).
layout(constant_id = 11) const bool DEPTH_BUFFER = false;

// Numbers of one frame: struct FrameNumbers (runtime/gpu/frame_numbers.h).
layout(push_constant) uniform FrameNumbers {
  ivec2 render_size;
  ivec2 output_size;
  vec2 jitter;  // render pixels
  vec2 jitter_before;
  vec2 motion_scale;  // from the motion image to render pixels, previous to current, y down
  float depth_a;
  float depth_b;
  float depth_threshold;
  float blend_a;
  float blend_b;
  float clamp_gamma;
  float gate_width;
  float settled_distance;
  float least_step;
  float residual_slack;
  float filter_parameter;
  float most_smoothing;
  float variance_unit;
  int has_history;
} frame;

bool IsFinite(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) < 0x7F800000u; }
bool IsNan(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u; }

// Where an output pixel lies among the samples of an axis: between cell and cell + 1 at `fraction`
// of the way, limited to the outermost; and at nearest + offset, not limited. As AxisMap, in whole
// numbers where it matters: 2 * output * render < 2^31.
struct AxisPlace {
  int cell;
  float fraction;
  int nearest;
  float offset;
};

// floor(a / b) for b > 0.
int FloorDivide(int a, int b) {
  int quotient = a / b;
  return a - quotient * b < 0 ? quotient - 1 : quotient;
}

AxisPlace PlaceOf(int x, int render, int output_, float jitter) {
  int numerator = (2 * x + 1) * render - output_;
  int whole = FloorDivide(numerator, 2 * output_);
  float rest = float(numerator - whole * 2 * output_) / float(2 * output_) - jitter;
  float carried = floor(rest);
  int cell = whole + int(carried);
  float fraction = rest - carried;
  if (cell < 0) {
    cell = 0;
    fraction = 0.0;
  } else if (cell >= render - 1) {
    cell = render - 1;
    fraction = 0.0;
  }
  int nearest = cell + int(fraction + 0.5);
  return AxisPlace(cell, fraction, nearest, float(whole - nearest) + rest);
}

// Where a sample lies among the output pixels: between texel and texel + 1, at `share`.
struct SamplePlace {
  int texel;
  float share;
};

SamplePlace SamplePlaceOf(int i, int render, int output_, float jitter) {
  int numerator = (2 * i + 1) * output_ - render;
  int whole = FloorDivide(numerator, 2 * render);
  float rest = float(numerator - whole * 2 * render) / float(2 * render) +
               jitter * (float(output_) / float(render));
  float carried = floor(rest);
  int texel = whole + int(carried);
  float share = rest - carried;
  int last = max(0, output_ - 2);
  if (texel < 0) return SamplePlace(0, 0.0);
  if (texel > last) return SamplePlace(last, output_ > 1 ? 1.0 : 0.0);
  return SamplePlace(texel, share);
}

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

// A sample of the render grid as the passes work on it; beyond the edges the outermost.
vec3 LoadColor(sampler2D image, ivec2 p) {
  p = clamp(p, ivec2(0), frame.render_size - 1);
  return EncodeColor(texelFetch(image, p, 0).rgb);
}

float LoadDepth(sampler2D image, ivec2 p) {
  p = clamp(p, ivec2(0), frame.render_size - 1);
  float z = texelFetch(image, p, 0).r;
  float depth = DEPTH_BUFFER ? 1.0 / (frame.depth_a + frame.depth_b * z) : frame.depth_a * z;
  return !IsNan(depth) && depth >= 0.0 && depth < kFarthestDepth ? depth : kFarthestDepth;
}

// Motion in render pixels; kNoMotion in x where either component is not finite. That points out of
// every image, so that there is no history.
vec2 LoadMotion(sampler2D image, ivec2 p) {
  p = clamp(p, ivec2(0), frame.render_size - 1);
  vec2 m = texelFetch(image, p, 0).xy;
  return IsFinite(m.x) && IsFinite(m.y) ? m * frame.motion_scale : vec2(kNoMotion, 0.0);
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

float SampleWeight(float distance_) { return max(1.0 - frame.blend_b * distance_, 0.0); }
float BlendShare(float weight) { return min(frame.blend_a * weight, 1.0); }

// The weights of the taps -1 to 2 (luts/filters.h).
vec4 KeysTaps(float a, float d) {
  float e = 1.0 - d;
  float outer0 = a * d * e * e;
  float outer3 = a * e * d * d;
  float inner1 = ((a + 2.0) * d - (a + 3.0)) * d * d + 1.0;
  return vec4(outer0, inner1, 1.0 - inner1 - outer0 - outer3, outer3);
}
