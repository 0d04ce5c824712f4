// Tiles of the render grid: how much smoother the history is updated, runtime/sr/aliasing.h.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D smoothing;
layout(binding = 1) uniform sampler2D variances;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  ivec2 tiles = (frame.render_size + kAliasingTile - 1) / kAliasingTile;
  if (any(greaterThanEqual(p, tiles))) return;
  const float kBinomial[5] = float[5](1.0 / 16.0, 4.0 / 16.0, 6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0);
  float variance = 0.0;
  for (int dy = -2; dy <= 2; ++dy) {
    float row = 0.0;
    for (int dx = -2; dx <= 2; ++dx) {
      ivec2 tap = clamp(p + ivec2(dx, dy), ivec2(0), tiles - 1);
      row += kBinomial[dx + 2] * texelFetch(variances, tap, 0).r;
    }
    variance += kBinomial[dy + 2] * row;
  }
  float deviation = sqrt(variance / frame.variance_unit);
  float ramp = clamp((deviation - kLeastAliasing) / (kMostAliasing - kLeastAliasing), 0.0, 1.0);
  imageStore(smoothing, p, vec4(frame.most_smoothing * ramp));
}
