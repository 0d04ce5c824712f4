// Grid of the frame: each pixel of frame 1 arrives at a pixel of the generated frame; of several the
// least key is kept, whatever their order.
//
// The key has 64 bits, atomics of 32 bits are everywhere: one dispatch keeps the least depth, the
// next, behind a barrier, the least index among the pixels of that depth. The result is that of one
// atomic minimum of 64 bits; the cost is that motion and depth are read twice.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "generation.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 18) const bool KEEPS_DEPTH = true;  // the first of the dispatches

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.output_size))) return;
  ivec2 q = NearestPixel(p, ForwardDisplacement(p));
  if (q.x < 0) return;
  int at = 2 * PixelIndex(q);
  uint depth = floatBitsToUint(DepthAt(depth1, p));
  if (KEEPS_DEPTH) {
    atomicMin(keys[at + 1], depth);
  } else if (keys[at + 1] == depth) {
    atomicMin(keys[at], uint(PixelIndex(p)));
  }
}
