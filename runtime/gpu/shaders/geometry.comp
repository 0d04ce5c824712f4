// Output grid: depth and motion of the frame, as frame generation takes them. Motion is in output
// pixels; both components are NaN where there is none.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D output_depth;
layout(binding = 1, rgba32f) writeonly uniform image2D output_motion;
layout(binding = 2) uniform sampler2D depth;
layout(binding = 3) uniform sampler2D motion;
#include "surface.glsl"

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.output_size))) return;
  AxisPlace x = PlaceOf(p.x, frame.render_size.x, frame.output_size.x, frame.jitter.x);
  AxisPlace y = PlaceOf(p.y, frame.render_size.y, frame.output_size.y, frame.jitter.y);
  Surface surface = SurfaceAt(x, y);
  vec2 m = surface.motion * (vec2(frame.output_size) / vec2(frame.render_size));
  if (surface.motion.x >= kNoMotion) m = vec2(uintBitsToFloat(kNanBits));
  imageStore(output_depth, p, vec4(surface.depth));
  imageStore(output_motion, p, vec4(m, 0.0, 0.0));
}
