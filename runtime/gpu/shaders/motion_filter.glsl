// What the two passes of the motion filter share (runtime/motion_filter.h): numbers of the frame, the
// camera that the first hands to the second, depth, motion, and the motion of still points.
#include "formulas.glsl"

// struct MotionFilterNumbers (runtime/gpu/frame_numbers.h).
layout(push_constant) uniform MotionFilterNumbers {
  ivec2 size;
  vec2 motion_scale;  // from the motion image to pixels, previous to current, y down
  float depth_a;
  float depth_b;
  float limit;      // the largest change of a component, pixels
  int sample_step;  // the distance of samples, pixels
} frame;

// The coefficients of CameraMotion (runtime/camera_motion.h), then the limits of x and y in pixels.
layout(std430, binding = 0) buffer Camera { float camera[kCameraUnknowns + 2]; };

struct Point {
  vec2 position;        // from the image centre, in units of half the width
  float inverse_depth;  // runtime/camera_motion.h
  vec2 motion;          // pixels
};

Point PointAt(sampler2D depth, sampler2D motion, ivec2 p) {
  float z = CleanDepth(texelFetch(depth, p, 0).r, frame.depth_a, frame.depth_b);
  float inverse_depth = z < kFarthestDepth ? 1.0 / max(z, kLeastDepth) : 0.0;
  vec2 position = vec2(2 * p + 1 - frame.size) / float(frame.size.x);
  return Point(position, inverse_depth, texelFetch(motion, p, 0).xy * frame.motion_scale);
}

// One unit of positions, in pixels.
float PixelsOfUnit() { return 0.5 * float(frame.size.x); }

// h of runtime/camera_motion.h.
float Foreshortening(float c[kCameraUnknowns], Point point) {
  return c[8] * point.position.x + c[9] * point.position.y + c[10] * point.inverse_depth;
}

// The motion of a still point in units of half the width.
vec2 CameraMotionOf(float c[kCameraUnknowns], Point point) {
  vec4 a = vec4(point.position, 1.0, point.inverse_depth);
  float h = Foreshortening(c, point);
  vec2 plane = vec2(dot(vec4(c[0], c[1], c[2], c[3]), a), dot(vec4(c[4], c[5], c[6], c[7]), a));
  return (plane + point.position * h) / (1.0 + h);
}
