// Output grid, one axis: the prefilter of the history, luts/prefilter.h. Columns first, then rows.
//
// A group filters kLines lines of kLength pixels, with `reach` more on each side, in shared memory.
// The recursions start there with their first input; what that lacks has decayed where the tile
// begins. A FIR sums the pixels around each.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "constants.glsl"
const int kLines = 8;
const int kLength = 64;
const int kThreads = 64;
const int kStride = kLength + 2 * kLargestPrefilterReach;
layout(local_size_x = 64) in;
layout(constant_id = 0) const bool RECURSIVE = true;
layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D coefficients;
layout(binding = 1) uniform sampler2D samples;

// struct PrefilterNumbers (runtime/gpu/frame_numbers.h).
layout(push_constant) uniform PrefilterNumbers {
  ivec2 size;
  int along_x;  // 1: rows, 0: columns
  int reach;
  float pole;
  vec4 taps[(kLargestFirReach + 1) / 4];  // t_0, t_1, ...
} pass_;

shared float tile[kLines * kStride * 3];

// For i of at least -kLargestPrefilterReach; the remainder of a negative number is not defined.
int Mirrored(int i, int size) {
  int period = 2 * size;
  int inside = (i + kLargestPrefilterReach * period) % period;
  return inside < size ? inside : period - 1 - inside;
}

ivec2 Pixel(int along, int line) {
  return pass_.along_x == 1 ? ivec2(along, line) : ivec2(line, along);
}

float Counted(float x) { return abs(x) <= kLargestPrefiltered ? x : 0.0; }

void main() {
  int thread = int(gl_LocalInvocationID.x);
  int first = int(gl_WorkGroupID.x) * kLength;
  int first_line = int(gl_WorkGroupID.y) * kLines;
  int length_ = pass_.along_x == 1 ? pass_.size.x : pass_.size.y;
  int lines = pass_.along_x == 1 ? pass_.size.y : pass_.size.x;
  int reach = pass_.reach;
  int count = kLength + 2 * reach;

  for (int k = thread; k < kLines * count; k += kThreads) {
    int line = k / count;
    int i = k - line * count;
    ivec2 p = Pixel(Mirrored(first - reach + i, length_), min(first_line + line, lines - 1));
    vec3 x = texelFetch(samples, p, 0).rgb;
    int at = (line * kStride + i) * 3;
    tile[at] = Counted(x.r);
    tile[at + 1] = Counted(x.g);
    tile[at + 2] = Counted(x.b);
  }
  barrier();
  if (RECURSIVE && thread < 3 * kLines) {
    int start = thread / 3 * kStride * 3 + thread % 3;
    float state = tile[start];
    for (int i = 1; i < count; ++i) {
      float x = tile[start + 3 * i];
      state = x + pass_.pole * (state - x);
      tile[start + 3 * i] = state;
    }
    for (int i = count - 2; i >= reach; --i) {
      float x = tile[start + 3 * i];
      state = x + pass_.pole * (state - x);
      tile[start + 3 * i] = state;
    }
  }
  barrier();
  for (int k = thread; k < kLines * kLength; k += kThreads) {
    int line = k / kLength;
    int i = k - line * kLength;
    if (first + i >= length_ || first_line + line >= lines) continue;
    int at = (line * kStride + i + reach) * 3;
    vec3 c = vec3(tile[at], tile[at + 1], tile[at + 2]);
    if (!RECURSIVE) {
      vec3 x = c;
      for (int j = 1; j <= reach; ++j) {
        int a = at - 3 * j, b = at + 3 * j;
        vec3 both = vec3(tile[a] + tile[b], tile[a + 1] + tile[b + 1], tile[a + 2] + tile[b + 2]);
        c += pass_.taps[j / 4][j % 4] * (both - 2.0 * x);
      }
    }
    imageStore(coefficients, Pixel(first + i, first_line + line), vec4(c, 0.0));
  }
}
