// Render grid: the greatest reactive value of the 4 x 4 samples from (-1, -1) to (2, 2), as the next
// frame reads it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D reach;
layout(binding = 1) uniform sampler2D reactive;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.render_size))) return;
  float greatest = 0.0;
  for (int dj = -1; dj <= 2; ++dj) {
    for (int di = -1; di <= 2; ++di) greatest = max(greatest, LoadReactive(reactive, p + ivec2(di, dj)));
  }
  imageStore(reach, p, vec4(greatest));
}
