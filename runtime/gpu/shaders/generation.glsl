// What the passes of frame generation share: options, numbers of the call, depth and motion of both
// frames, the way of a pixel of frame 1. Formulas follow runtime/generation line by line.
//
// Choices of a pixel (the nearest pixel, an arrival, a gap) are `precise`: without fused operations
// they are those of the processor, to the bit.
#include "formulas.glsl"

// Choices of FrameGenerationOptions, as in runtime/choices.h; and which frame is made.
layout(constant_id = 12) const int MODEL = kMotionModelPerspective;
layout(constant_id = 13) const bool SPLAT = true;
layout(constant_id = 14) const bool REFINE = true;
layout(constant_id = 15) const int FILL = kDisocclusionFillOwnMotion;
layout(constant_id = 16) const bool BRIGHTNESS_GATE = false;
layout(constant_id = 17) const bool INTERPOLATES = true;

// struct GenerationNumbers (runtime/gpu/frame_numbers.h).
layout(push_constant) uniform GenerationNumbers {
  ivec2 output_size;
  vec2 motion_scale;  // from the motion images to pixels, previous to current, y down
  float depth_a;
  float depth_b;
  float depth_threshold;
  float brightness_threshold;
  float gate_width;
  float filter_parameter;
  float alpha;
  int counts_motion0;  // frame 0 is no cut
} frame;

layout(binding = 2) uniform sampler2D depth0;
layout(binding = 3) uniform sampler2D depth1;
layout(binding = 4) uniform sampler2D motion0;
layout(binding = 5) uniform sampler2D motion1;
// What arrives at pixel (x, y), in two words from 2 (y width + x) on: the index of the source pixel
// and the bits of its depth. Both are kNoArrival where there is none. The two together are the key
// of runtime/generation/splat_key.h.
layout(std430, binding = 0) buffer Arrivals { uint keys[]; };

vec2 Nowhere() { return vec2(uintBitsToFloat(kNanBits)); }
bool IsFiniteVector(vec2 v) { return IsFinite(v.x) && IsFinite(v.y); }

float DepthAt(sampler2D depth, ivec2 p) {
  return CleanDepth(texelFetch(depth, p, 0).r, frame.depth_a, frame.depth_b);
}

vec2 MotionAt(sampler2D motion, ivec2 p) { return texelFetch(motion, p, 0).xy * frame.motion_scale; }

int PixelIndex(ivec2 p) { return p.y * frame.output_size.x + p.x; }
ivec2 PixelOfIndex(uint index) {
  uint width = uint(frame.output_size.x);
  return ivec2(index % width, index / width);
}
bool Contains(ivec2 p) {
  return all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, frame.output_size));
}

// The pixel nearest to pixel p moved by d, halves towards the lower right; x is -1 outside of the
// image or where d is not finite.
ivec2 NearestPixel(ivec2 p, vec2 d) {
  if (!IsFiniteVector(d)) return ivec2(-1);
  precise vec2 moved = vec2(p) + d;
  precise vec2 f = floor(moved + 0.5);
  bool inside = f.x >= 0.0 && f.x < float(frame.output_size.x) && f.y >= 0.0 &&
                f.y < float(frame.output_size.y);
  return inside ? ivec2(f) : ivec2(-1);
}

// Whether the path is that of the perspective model; where frame 0 is a cut it is linear.
bool FollowsPerspective() {
  return MODEL == kMotionModelPerspective && frame.counts_motion0 != 0;
}
#include "perspective.glsl"

// Displacement of pixel p of frame 1 to the generated frame; not finite where it arrives nowhere.
vec2 ForwardDisplacement(ivec2 p) {
  vec2 m1 = MotionAt(motion1, p);
  if (!IsFiniteVector(m1)) return Nowhere();
  if (FollowsPerspective()) return PerspectiveDisplacement(p, m1);
  precise vec2 m0 = m1;
  if (MODEL == kMotionModelQuadratic && frame.counts_motion0 != 0) {
    ivec2 p0 = NearestPixel(p, -m1);
    if (p0.x >= 0) {
      vec2 before = MotionAt(motion0, p0);
      if (IsFiniteVector(before)) {
        float difference = DepthDifference(DepthAt(depth0, p0), DepthAt(depth1, p));
        float gate = Gate(abs(difference), frame.depth_threshold, frame.gate_width);
        m0 = m1 + gate * (before - m1);
      }
    }
  }
  precise float first = 0.5 * frame.alpha;
  precise float second = first * frame.alpha;
  precise vec2 bend = second * (m1 - m0);
  precise vec2 d;
  if (INTERPOLATES) {
    d = first * (m1 + m0) + bend - m1;
  } else {
    d = first * (3.0 * m1 - m0) + bend;
  }
  return d;
}
