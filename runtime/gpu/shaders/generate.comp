// Grid of the frame: the motion of each pixel of the generated frame, frames 0 and 1 warped by it,
// and their blend (interpolation); or frame 1 alone (extrapolation).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "generation.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1, HISTORY_FORMAT) writeonly uniform image2D generated;
// Colours, or their codes in linear HDR; and their coefficients.
layout(binding = 6) uniform sampler2D color0;
layout(binding = 7) uniform sampler2D color1;
layout(binding = 8) uniform sampler2D coefficients0;
layout(binding = 9) uniform sampler2D coefficients1;
layout(binding = 10) uniform sampler2DArray table;
#include "target_motion.glsl"

// Channels that are no finite numbers count as 0.
vec4 WarpedTexel(sampler2D image, ivec2 p) {
  vec4 texel = texelFetch(image, p, 0);
  if (ENCODING == kColorEncodingLinearHdr) return texel;
  return vec4(IsFinite(texel.r) ? texel.r : 0.0, IsFinite(texel.g) ? texel.g : 0.0,
              IsFinite(texel.b) ? texel.b : 0.0, 1.0);
}
#include "warp.glsl"

// A code is no more than the greatest of its 4 x 4 texels, unless it is at most kUnlimitedCode.
vec3 LimitedCode(sampler2D codes, ivec2 p, vec2 motion, vec3 code) {
  if (max(max(code.r, code.g), code.b) <= kUnlimitedCode) return code;
  ivec2 texel = SampledPlaceOf(p, motion).texel;
  vec3 brightest = vec3(kUnlimitedCode);
  for (int j = -1; j <= 2; ++j) {
    for (int i = -1; i <= 2; ++i) {
      brightest = max(brightest, FetchSummed(codes, texel + ivec2(i, j)).rgb);
    }
  }
  return min(code, brightest);
}

vec3 WarpedColor(sampler2D color, sampler2D coefficients, ivec2 p, vec2 motion) {
  vec3 warped = WarpedImage(color, coefficients, p, motion).rgb;
  if (ENCODING == kColorEncodingLinearHdr) warped = LimitedCode(color, p, motion, warped);
  return vec3(IsNan(warped.r) ? 0.0 : clamp(warped.r, 0.0, 1.0),
              IsNan(warped.g) ? 0.0 : clamp(warped.g, 0.0, 1.0),
              IsNan(warped.b) ? 0.0 : clamp(warped.b, 0.0, 1.0));
}

// The least depth of the 3 x 3 pixels around p that lie in the image.
float LeastDepthAround(sampler2D depth, ivec2 p) {
  float least = kFarthestDepth;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      least = min(least, DepthAt(depth, clamp(p + ivec2(i, j), ivec2(0), frame.output_size - 1)));
    }
  }
  return least;
}

float Brightness(vec3 color) { return dot(kBrightnessWeights, color); }

// runtime/gates.h.
float InterpolationShare(float depth_difference, float brightness_difference) {
  float frame0 = 1.0 - Gate(depth_difference, frame.depth_threshold, frame.gate_width);
  float frame1 = 1.0 - Gate(-depth_difference, frame.depth_threshold, frame.gate_width);
  float alike = Gate(abs(brightness_difference), frame.brightness_threshold, frame.gate_width);
  float nearer = frame.alpha >= 0.5 ? 1.0 : 0.0;
  float blended = alike * nearer + (1.0 - alike) * frame.alpha;
  return frame1 + (1.0 - frame0 - frame1) * blended;
}

// The share of frame 1 (runtime/generation/blend.h).
float FrameShare(ivec2 p, TargetMotion motion, vec3 warped0, vec3 warped1) {
  ivec2 p0 = NearestPixel(p, -motion.from0);
  ivec2 p1 = NearestPixel(p, -motion.from1);
  if (p0.x < 0 && p1.x < 0) return frame.alpha >= 0.5 ? 1.0 : 0.0;
  if (p0.x < 0) return 1.0;
  if (p1.x < 0) return 0.0;
  float depth = 0.0;
  if (DEPTH != kDepthMeasureNone) {
    depth = DepthDifference(LeastDepthAround(depth0, p0), LeastDepthAround(depth1, p1));
  }
  float brightness = BRIGHTNESS_GATE ? Brightness(warped0) - Brightness(warped1) : kUnlike;
  return InterpolationShare(depth, brightness);
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.output_size))) return;
  TargetMotion motion = TargetMotionAt(p);
  vec3 color = WarpedColor(color1, coefficients1, p, motion.from1);
  if (INTERPOLATES) {
    vec3 before = WarpedColor(color0, coefficients0, p, motion.from0);
    color = before + FrameShare(p, motion, before, color) * (color - before);
  }
  imageStore(generated, p, vec4(DecodeColor(color), 1.0));
}
