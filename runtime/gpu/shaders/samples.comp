// Render grid: the colour box of the 3 x 3 samples around each sample.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D box_low;
layout(binding = 1, HISTORY_FORMAT) writeonly uniform image2D box_high;
layout(binding = 2) uniform sampler2D color;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.render_size))) return;
  vec3 low = vec3(1.0), high = vec3(0.0), mean = vec3(0.0), square = vec3(0.0);
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      vec3 s = LoadColor(color, p + ivec2(di, dj));
      float weight = (dj == 0 ? kBoxMiddle : kBoxSide) * (di == 0 ? kBoxMiddle : kBoxSide);
      low = min(low, s);
      high = max(high, s);
      mean += weight * s;
      square += weight * s * s;
    }
  }
  if (CLAMP == kColorClampVariance) {
    vec3 reach = frame.clamp_gamma * sqrt(max(square - mean * mean, vec3(0.0)));
    low = mean - reach;
    high = mean + reach;
  }
  if (CLAMP == kColorClampNone) {
    low = vec3(0.0);
    high = vec3(1.0);
  }
  imageStore(box_low, p, vec4(clamp(low, 0.0, 1.0), 0.0));
  imageStore(box_high, p, vec4(clamp(high, 0.0, 1.0), 0.0));
}
