// Output grid: steps 1 to 3 of runtime/super_resolution.h: motion and depth, the warped history, its
// validity (in alpha) and the limit to the colour box.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D predicted;
layout(binding = 1) uniform sampler2D color;
layout(binding = 2) uniform sampler2D depth;
layout(binding = 3) uniform sampler2D motion;
layout(binding = 4) uniform sampler2D history;
layout(binding = 5) uniform sampler2D coefficients;
layout(binding = 6) uniform sampler2DArray table;
layout(binding = 7) uniform sampler2D box_low;
layout(binding = 8) uniform sampler2D box_high;
layout(binding = 9) uniform sampler2D nearest_before;
layout(binding = 10) uniform sampler2D farthest_before;
layout(binding = 11) uniform sampler2D reactive;
layout(binding = 12) uniform sampler2D reactive_before;
#include "surface.glsl"

vec4 WarpedTexel(sampler2D image, ivec2 p) { return texelFetch(image, p, 0); }
#include "warp.glsl"

// The sample of the frame before at or before a position of the output grid.
ivec2 CellBefore(vec2 position) {
  vec2 inverse_scale = vec2(frame.render_size_before) / vec2(frame.output_size);
  vec2 u = position * inverse_scale - 0.5 - frame.jitter_before;
  return ivec2(clamp(u, vec2(0.0), vec2(frame.render_size_before - 1)));
}

// How much of the history counts by the depth, in [0, 1]; `before` is where it comes from.
float ValidityAt(vec2 before, float depth) {
  bool inside = before.x >= 0.0 && before.x <= float(frame.output_size.x) && before.y >= 0.0 &&
                before.y <= float(frame.output_size.y);
  if (!HISTORY || frame.has_history == 0 || !inside) return 0.0;
  if (DEPTH == kDepthMeasureNone) return 1.0;
  ivec2 cell = CellBefore(before);
  float near = texelFetch(nearest_before, cell, 0).r;
  float far = texelFetch(farthest_before, cell, 0).r;
  float farther = DepthDifference(depth, clamp(depth, near, far));
  if (DEPTH == kDepthMeasureAbsolute) farther = abs(farther);
  return Gate(farther, frame.depth_threshold, frame.gate_width);
}

// How reactive an output pixel is: the greatest of the four samples around it, and of what the frame
// before left where the history comes from.
float ReactiveAt(ivec2 cell, vec2 before) {
  float greatest = texelFetch(reactive_before, CellBefore(before), 0).r;
  for (int k = 0; k < 4; ++k)
    greatest = max(greatest, LoadReactive(reactive, cell + ivec2(k & 1, k >> 1)));
  return greatest;
}

// The current frame alone.
vec3 CurrentFrameAt(AxisPlace x, AxisPlace y) {
  vec4 wx = vec4(0.0, 1.0 - x.fraction, x.fraction, 0.0);
  vec4 wy = vec4(0.0, 1.0 - y.fraction, y.fraction, 0.0);
  if (CURRENT == kCurrentFrameBicubic) {
    wx = KeysTaps(kCatmullRomA, x.fraction);
    wy = KeysTaps(kCatmullRomA, y.fraction);
  }
  vec3 sum = vec3(0.0);
  for (int ky = 0; ky < 4; ++ky) {
    if (CURRENT == kCurrentFrameBilinear && (ky == 0 || ky == 3)) continue;
    vec3 row = vec3(0.0);
    for (int kx = 0; kx < 4; ++kx) {
      if (CURRENT == kCurrentFrameBilinear && (kx == 0 || kx == 3)) continue;
      row += wx[kx] * LoadColor(color, ivec2(x.cell + kx - 1, y.cell + ky - 1));
    }
    sum += wy[ky] * row;
  }
  return clamp(sum, 0.0, 1.0);
}

vec3 BoxAt(sampler2D box, ivec2 cell, vec2 t) {
  ivec2 last = frame.render_size - 1;
  ivec2 next = min(cell + 1, last);
  vec3 left = mix(texelFetch(box, cell, 0).rgb, texelFetch(box, ivec2(cell.x, next.y), 0).rgb, t.y);
  vec3 right = mix(texelFetch(box, ivec2(next.x, cell.y), 0).rgb, texelFetch(box, next, 0).rgb, t.y);
  return left + t.x * (right - left);
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.output_size))) return;
  AxisPlace x = PlaceOf(p.x, frame.render_size.x, frame.output_size.x, frame.jitter.x);
  AxisPlace y = PlaceOf(p.y, frame.render_size.y, frame.output_size.y, frame.jitter.y);
  Surface surface = SurfaceAt(x, y);
  vec2 scale = vec2(frame.output_size) / vec2(frame.render_size);
  vec2 output_motion = surface.motion * scale;
  vec2 before = vec2(p) + 0.5 - output_motion;
  float validity = ValidityAt(before, surface.depth);
  if (REACTIVE && validity > 0.0) validity *= 1.0 - ReactiveAt(ivec2(x.cell, y.cell), before);
  vec3 result = vec3(0.0);
  if (validity < 1.0) result = CurrentFrameAt(x, y);
  if (validity > 0.0) {
    vec3 warped = MOTION == kMotionUpsamplingStatic ? texelFetch(history, p, 0).rgb
                                                    : WarpedImage(history, coefficients, p, output_motion).rgb;
    ivec2 cell = ivec2(x.cell, y.cell);
    vec2 t = vec2(x.fraction, y.fraction);
    warped = clamp(warped, BoxAt(box_low, cell, t), BoxAt(box_high, cell, t));
    result = validity < 1.0 ? result + validity * (warped - result) : warped;
  }
  imageStore(predicted, p, vec4(result, validity));
}
