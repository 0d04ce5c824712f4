// Grid of the frame: linear HDR to the codes that are warped and blended.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "formulas.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D codes;
layout(binding = 1) uniform sampler2D color;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(codes)))) return;
  imageStore(codes, p, vec4(EncodeColor(texelFetch(color, p, 0).rgb), 1.0));
}
