// Render grid: each sample's difference from the prediction at its own position, by Catmull-Rom, and
// the variance of each tile of them. A group is a tile.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 16, local_size_y = 16) in;  // kAliasingTile
layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D residual;
layout(binding = 1, r32f) writeonly uniform image2D variances;
layout(binding = 2) uniform sampler2D color;
layout(binding = 3) uniform sampler2D predicted;

const int kTilePixels = kAliasingTile * kAliasingTile;
shared vec4 sums[kTilePixels];

vec3 ResidualAt(ivec2 p) {
  SamplePlace x = SamplePlaceOf(p.x, frame.render_size.x, frame.output_size.x, frame.jitter.x);
  SamplePlace y = SamplePlaceOf(p.y, frame.render_size.y, frame.output_size.y, frame.jitter.y);
  vec4 wx = KeysTaps(kCatmullRomA, x.share);
  vec4 wy = KeysTaps(kCatmullRomA, y.share);
  vec3 sum = vec3(0.0);
  for (int ky = 0; ky < 4; ++ky) {
    vec3 row = vec3(0.0);
    for (int kx = 0; kx < 4; ++kx) {
      ivec2 tap = clamp(ivec2(x.texel + kx - 1, y.texel + ky - 1), ivec2(0), frame.output_size - 1);
      row += wx[kx] * texelFetch(predicted, tap, 0).rgb;
    }
    sum += wy[ky] * row;
  }
  vec3 difference = LoadColor(color, p) - sum;
  return difference - clamp(difference, -frame.residual_slack, frame.residual_slack);
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  int thread = int(gl_LocalInvocationIndex);
  vec3 r = vec3(0.0);
  if (all(lessThan(p, frame.render_size))) {
    r = ResidualAt(p);
    imageStore(residual, p, vec4(r, 0.0));
  }
  sums[thread] = vec4(r, dot(r, r));
  barrier();
  for (int active_ = kTilePixels / 2; active_ > 0; active_ /= 2) {
    if (thread < active_) sums[thread] += sums[thread + active_];
    barrier();
  }
  if (thread != 0) return;
  ivec2 tile = ivec2(gl_WorkGroupID.xy);
  ivec2 size = min(frame.render_size - tile * kAliasingTile, ivec2(kAliasingTile));
  float n = float(size.x * size.y);
  vec4 total = sums[0];
  float variance = max(total.w - dot(total.xyz, total.xyz) / n, 0.0) / (3.0 * n);
  imageStore(variances, tile, vec4(variance));
}
