// Grid of the motion: what the camera explains within the limits becomes the camera's, in pixels.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "motion_filter.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1, rgba32f) writeonly uniform image2D filtered;
layout(binding = 2) uniform sampler2D depth;
layout(binding = 3) uniform sampler2D motion;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.size))) return;
  Point point = PointAt(depth, motion, p);
  float c[kCameraUnknowns];
  for (int i = 0; i < kCameraUnknowns; ++i) c[i] = camera[i];
  vec2 still = CameraMotionOf(c, point) * PixelsOfUnit();
  vec2 change = abs(still - point.motion);
  bool explained = IsFinite(change.x) && IsFinite(change.y) &&
                   change.x <= camera[kCameraUnknowns] && change.y <= camera[kCameraUnknowns + 1];
  imageStore(filtered, p, vec4(explained ? still : point.motion, 0.0, 0.0));
}
