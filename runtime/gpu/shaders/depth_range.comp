// Render grid: the least and greatest depth of the 4 x 4 samples from (-1, -1) to (2, 2), with which
// the next frame is compared.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D nearest;
layout(binding = 1, r32f) writeonly uniform image2D farthest;
layout(binding = 2) uniform sampler2D depth;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.render_size))) return;
  float least = LoadDepth(depth, p);
  float greatest = least;
  for (int dj = -1; dj <= 2; ++dj) {
    for (int di = -1; di <= 2; ++di) {
      float z = LoadDepth(depth, p + ivec2(di, dj));
      least = min(least, z);
      greatest = max(greatest, z);
    }
  }
  imageStore(nearest, p, vec4(least));
  imageStore(farthest, p, vec4(greatest));
}
