// Grid of the image: the image at p - m, runtime/warp.h, by the taps of a filter or a table; or by
// Catmull-Rom in 9 or 5 fetches that the sampler filters, to compare with.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "formulas.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 12) const int FETCHES = 16;  // of Catmull-Rom: 9 or 5 are filtered

// struct WarpNumbers (runtime/gpu/frame_numbers.h).
layout(push_constant) uniform WarpNumbers {
  ivec2 output_size;
  float filter_parameter;
} frame;

layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D warped;
layout(binding = 1) uniform sampler2D samples;
layout(binding = 2) uniform sampler2D coefficients;
layout(binding = 3) uniform sampler2DArray table;
layout(binding = 4) uniform sampler2D motion;  // pixels, before to now, y down

vec4 WarpedTexel(sampler2D image, ivec2 p) { return texelFetch(image, p, 0); }
#include "warp.glsl"

// The outer taps of each axis alone, the inner two in one fetch between them. With 5 fetches the
// corners are left out, and the rest weighs more.
vec4 FilteredCatmullRom(ivec2 texel, vec2 d) {
  vec4 wx = KeysTaps(kCatmullRomA, d.x);
  vec4 wy = KeysTaps(kCatmullRomA, d.y);
  vec2 inner = vec2(wx.y + wx.z, wy.y + wy.z);
  vec2 size = vec2(frame.output_size);
  vec2 first = (vec2(texel) - 0.5) / size;
  vec2 middle = (vec2(texel) + 0.5 + vec2(wx.z, wy.z) / inner) / size;
  vec2 last = (vec2(texel) + 2.5) / size;
  vec3 x = vec3(first.x, middle.x, last.x), y = vec3(first.y, middle.y, last.y);
  vec3 w = vec3(wx.x, inner.x, wx.w), v = vec3(wy.x, inner.y, wy.w);
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      if (FETCHES == 9 || i == 1 || j == 1) {
        sum += w[i] * v[j] * textureLod(samples, vec2(x[i], y[j]), 0.0);
        total += w[i] * v[j];
      }
    }
  }
  return FETCHES == 5 ? sum / total : sum;
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.output_size))) return;
  vec2 m = texelFetch(motion, p, 0).xy;
  vec4 color;
  if (FETCHES < 16) {
    SampledPlace place = SampledPlaceOf(p, m);
    color = FilteredCatmullRom(place.texel, place.offset);
  } else {
    color = WarpedImage(samples, coefficients, p, m);
  }
  imageStore(warped, p, color);
}
