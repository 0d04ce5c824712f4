// What the passes of super resolution share: options, numbers of the frame, positions on both grids,
// colours. Formulas follow runtime/sr/reference.h line by line; tests compare every pass with it.
#include "formulas.glsl"

// Choices of SuperResolutionOptions, as in runtime/choices.h.
layout(constant_id = 0) const int FORM = kHistoryFormAdaptive;
layout(constant_id = 1) const int CLAMP = kColorClampVariance;
layout(constant_id = 3) const int MOTION = kMotionUpsamplingEdgeAware;
layout(constant_id = 4) const int CURRENT = kCurrentFrameBilinear;
layout(constant_id = 6) const bool HISTORY = true;
layout(constant_id = 12) const bool REACTIVE = false;

// Numbers of one frame: struct FrameNumbers (runtime/gpu/frame_numbers.h).
layout(push_constant) uniform FrameNumbers {
  ivec2 render_size;
  ivec2 output_size;
  ivec2 render_size_before;
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

// A sample of the render grid as the passes work on it; beyond the edges the outermost.
vec3 LoadColor(sampler2D image, ivec2 p) {
  p = clamp(p, ivec2(0), frame.render_size - 1);
  return EncodeColor(texelFetch(image, p, 0).rgb);
}

float LoadDepth(sampler2D image, ivec2 p) {
  p = clamp(p, ivec2(0), frame.render_size - 1);
  float z = texelFetch(image, p, 0).r;
  return CleanDepth(z, frame.depth_a, frame.depth_b);
}

// Motion in render pixels; kNoMotion in x where either component is not finite. That points out of
// every image, so that there is no history.
vec2 LoadMotion(sampler2D image, ivec2 p) {
  p = clamp(p, ivec2(0), frame.render_size - 1);
  vec2 m = texelFetch(image, p, 0).xy;
  return IsFinite(m.x) && IsFinite(m.y) ? m * frame.motion_scale : vec2(kNoMotion, 0.0);
}

// In [0, 1]; NaN is 0.
float LoadReactive(sampler2D image, ivec2 p) {
  float r = texelFetch(image, clamp(p, ivec2(0), frame.render_size - 1), 0).r;
  return r > 0.0 && !IsNan(r) ? min(r, 1.0) : 0.0;
}

// runtime/gates.h.
float SampleWeight(float distance_) { return max(1.0 - frame.blend_b * distance_, 0.0); }
float BlendShare(float weight) { return min(frame.blend_a * weight, 1.0); }
