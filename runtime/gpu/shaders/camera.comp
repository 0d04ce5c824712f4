// One group: the camera that explains the motion of most samples, as CameraFit finds it
// (runtime/camera_motion.h), and the limits of the motion filter.
//
// 32 bits take the place of 64: each round solves for the correction of the camera before, so that
// later rounds find what rounding lost in earlier ones. Sums are added in a fixed order. No barrier
// depends on what memory holds.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "motion_filter.glsl"
layout(local_size_x = 256) in;
layout(binding = 1) uniform sampler2D depth;
layout(binding = 2) uniform sampler2D motion;

const int kThreads = 256;
const int kOwn = kCameraSamples / kThreads;  // the most samples of a thread
const int kParts = 16;                       // a sum has two steps of so many
const int kSums = 15;
// As kRidge of runtime/motion/camera_motion.cpp, for sums of 32 bits.
const float kRidge32 = 1e-6;
const uint kNoKey = 0xFFFFFFFFu;

shared vec4 parts[kThreads];
shared vec4 part_sums[kParts];
shared vec4 totals[kSums];
shared uint bins[kThreads];  // of a digit of 8 bits
shared uint bin_sums[kParts];
shared uvec2 digit;  // and the rank within its bin
shared float factor[kCameraUnknowns * kCameraUnknowns];
shared float scales[kCameraUnknowns];
shared float solution[kCameraUnknowns];
shared float c[kCameraUnknowns];

int thread;
int own_count;  // samples of a thread; some may lie beyond the last
// Of the samples of this thread: whether there is one, its weight by nearness, the distance of its
// motion from the camera's, and what a median is taken of.
bool counts[kOwn];
float nearness[kOwn];
vec2 distances[kOwn];
uint keys[kOwn];
vec4 sums[kSums];

// The number, which no compiler knows: it would unroll a loop, and take minutes.
int Unknown(int number) { return number + min(frame.size.x, 0); }

int FirstSample() { return (frame.sample_step - 1) / 2; }
ivec2 SampleGrid() { return (frame.size - FirstSample() + frame.sample_step - 1) / frame.sample_step; }
int SampleIndex(int own) { return thread + own * kThreads; }

// Motion is in units of half the width.
Point SampleAt(int own) {
  int i = SampleIndex(own), columns = max(SampleGrid().x, 1);
  ivec2 p = FirstSample() + frame.sample_step * ivec2(i % columns, i / columns);
  Point point = PointAt(depth, motion, min(p, frame.size - 1));
  point.motion /= PixelsOfUnit();
  return point;
}

// `totals` become the sums of the `sums` of all threads.
void AddSums() {
  int count = Unknown(kSums);
  for (int sum = 0; sum < count; ++sum) {
    parts[thread] = sums[sum];
    barrier();
    if (thread < kParts) {
      vec4 part = vec4(0.0);
      for (int i = 0; i < kParts; ++i) part += parts[thread + i * kParts];
      part_sums[thread] = part;
    }
    barrier();
    if (thread == 0) {
      vec4 total = vec4(0.0);
      for (int i = 0; i < kParts; ++i) total += part_sums[i];
      totals[sum] = total;
    }
  }
  barrier();
}

// The key before which `rank` others come, digit by digit from the highest.
uint KeyOfRank(uint rank) {
  uint found = 0u, known = 0u;
  for (int shift = Unknown(24); shift >= 0; shift -= 8) {
    bins[thread] = 0u;
    barrier();
    for (int own = 0; own < own_count; ++own) {
      if ((keys[own] & known) == found) atomicAdd(bins[int((keys[own] >> shift) & 0xFFu)], 1u);
    }
    barrier();
    if (thread < kParts) {
      uint sum = 0u;
      for (int i = 0; i < kParts; ++i) sum += bins[thread * kParts + i];
      bin_sums[thread] = sum;
    }
    barrier();
    if (thread == 0) {
      uint below = 0u;
      int part = 0, last = Unknown(kParts) - 1;
      for (; part < last && below + bin_sums[part] <= rank; ++part) below += bin_sums[part];
      int bin = part * kParts;
      last += bin;
      for (; bin < last && below + bins[bin] <= rank; ++bin) below += bins[bin];
      digit = uvec2(uint(bin), rank - below);
    }
    barrier();
    found |= digit.x << shift;
    rank = digit.y;
    known |= 0xFFu << shift;
  }
  return found;
}

// The first keys are inverse depths. How many samples count, and how many have a depth.
vec2 Gather() {
  vec2 count = vec2(0.0);
  for (int own = 0; own < own_count; ++own) {
    Point s = SampleAt(own);
    ivec2 grid = SampleGrid();
    counts[own] = SampleIndex(own) < grid.x * grid.y && IsFinite(s.motion.x) && IsFinite(s.motion.y);
    nearness[own] = s.inverse_depth;
    distances[own] = vec2(0.0);
    bool has_depth = counts[own] && s.inverse_depth > 0.0;
    keys[own] = has_depth ? floatBitsToUint(s.inverse_depth) : kNoKey;
    count += vec2(counts[own] ? 1.0 : 0.0, has_depth ? 1.0 : 0.0);
  }
  return count;
}

// The distances along an axis become the keys. One that is not a number, as where 1 + h is 0, is a
// large one.
void MeasureDistances(int axis) {
  for (int own = 0; own < own_count; ++own) {
    Point s = SampleAt(own);
    float d = abs(s.motion - CameraMotionOf(c, s))[axis];
    distances[own][axis] = IsFinite(d) ? min(d, kFarthestDepth) : kFarthestDepth;
    keys[own] = counts[own] ? floatBitsToUint(distances[own][axis]) : kNoKey;
  }
}

// Nearness from inverse depths whose median is `middle`.
void MeasureNearness(float middle) {
  for (int own = 0; own < own_count; ++own) {
    float medians = nearness[own] / (kNearMedians * middle);
    nearness[own] = 1.0 / (1.0 + medians * medians);
  }
}

// The normal equations of the correction: those of c, linear once multiplied by 1 + h, with what c
// leaves on the right. The unknowns 0 to 3 are of x, 4 to 7 of y, both with the row `a`; 8 to 10 are
// of both. `sums` hold the block of a (0 to 3), those of a and x, a and y (4 to 9), the diagonal of
// the last block and what is beside it, and the right hand side.
void Accumulate(vec2 cut) {
  for (int i = 0; i < kSums; ++i) sums[i] = vec4(0.0);
  for (int own = 0; own < own_count; ++own) {
    Point s = SampleAt(own);
    float h = Foreshortening(c, s);
    bool is_near = distances[own].x <= cut.x && distances[own].y <= cut.y;
    if (!(counts[own] && is_near) || 1.0 + h == 0.0) continue;
    float weight = nearness[own] / ((1.0 + h) * (1.0 + h));
    vec4 a = vec4(s.position, 1.0, s.inverse_depth), weighted = weight * a;
    vec2 before = s.position - s.motion;
    vec3 bx = before.x * a.xyw, by = before.y * a.xyw;
    for (int i = 0; i < 4; ++i) sums[i] += weighted[i] * a;
    for (int i = 0; i < 3; ++i) {
      sums[4 + i] += bx[i] * weighted;
      sums[7 + i] += by[i] * weighted;
    }
    sums[10].xyz += weight * (bx * bx + by * by);
    sums[11].xyz += weight * (bx.xxy * bx.yzz + by.xxy * by.yzz);
    vec2 plane = vec2(dot(vec4(c[0], c[1], c[2], c[3]), a), dot(vec4(c[4], c[5], c[6], c[7]), a));
    vec2 left = s.motion - plane - before * h;
    sums[12] += left.x * weighted;
    sums[13] += left.y * weighted;
    sums[14].xyz += weight * (left.x * bx + left.y * by);
  }
  AddSums();
}

// An entry of the lower triangle.
float Entry(int i, int j) {
  if (i < 8) return (i < 4) == (j < 4) ? totals[j & 3][i & 3] : 0.0;
  if (j < 8) return totals[(j < 4 ? 4 : 7) + i - 8][j & 3];
  return i == j ? totals[10][i - 8] : totals[11][i + j - 17];
}

// The Cholesky factor of the equations scaled to a unit diagonal, a thread for each row.
void Factorise() {
  int unknowns = Unknown(kCameraUnknowns), first = thread * kCameraUnknowns;
  if (thread < unknowns) {
    float own = Entry(thread, thread);
    scales[thread] = own > 0.0 ? 1.0 / sqrt(own) : 0.0;
  }
  barrier();
  for (int j = 0; j < unknowns; ++j) {
    if (thread >= j && thread < unknowns) {
      float pivot = 1.0 + kRidge32;
      float sum = thread == j ? pivot : Entry(thread, j) * scales[thread] * scales[j];
      for (int k = 0; k < j; ++k) {
        float above = factor[j * kCameraUnknowns + k];
        pivot -= above * above;
        sum -= factor[first + k] * above;
      }
      pivot = sqrt(max(pivot, kRidge32));
      factor[first + j] = thread == j ? pivot : sum / pivot;
    }
    barrier();
  }
}

void Correct() {
  int unknowns = Unknown(kCameraUnknowns);
  if (thread == 0) {
    for (int i = 0; i < unknowns; ++i) {
      float sum = totals[12 + i / 4][i & 3] * scales[i];
      for (int k = 0; k < i; ++k) sum -= factor[i * kCameraUnknowns + k] * solution[k];
      solution[i] = sum / factor[i * kCameraUnknowns + i];
    }
    for (int i = unknowns - 1; i >= 0; --i) {
      float sum = solution[i];
      for (int k = i + 1; k < unknowns; ++k) sum -= factor[k * kCameraUnknowns + i] * solution[k];
      solution[i] = sum / factor[i * kCameraUnknowns + i];
      c[i] += solution[i] * scales[i];
    }
  }
  barrier();
}

void main() {
  thread = int(gl_LocalInvocationIndex);
  own_count = (SampleGrid().x * SampleGrid().y + kThreads - 1) / kThreads;
  if (thread < kCameraUnknowns) c[thread] = 0.0;
  sums[0].xy = Gather();
  AddSums();
  vec2 count = totals[0].xy;
  vec2 noise = vec2(0.0);
  int rounds = Unknown(kCameraRounds);
  // Stage 0 has the median of the inverse depth, the others that of the distances in each axis.
  for (int stage = 0; stage <= rounds; ++stage) {
    for (int axis = 0; axis < (stage == 0 ? 1 : 2); ++axis) {
      if (stage > 0) MeasureDistances(axis);
      noise[axis] = uintBitsToFloat(KeyOfRank(uint(stage == 0 ? count.y : count.x) / 2u));
    }
    vec2 cut = max((stage <= kHalvingRounds ? 1.0 : kNoiseToLimit) * noise,
                   vec2(kLeastCut / PixelsOfUnit()));
    if (stage == 0) {
      MeasureNearness(count.y > 0.0 ? noise.x : 1.0);
      cut = vec2(kFarthestDepth);
    }
    if (stage == rounds) break;
    Accumulate(cut);
    Factorise();
    Correct();
  }
  if (thread != 0) return;
  bool is_known = count.x >= float(kLeastSamples);
  for (int i = 0; i < kCameraUnknowns; ++i) camera[i] = is_known ? c[i] : 0.0;
  vec2 limits = min(vec2(frame.limit), kNoiseToLimit * noise * PixelsOfUnit());
  camera[kCameraUnknowns] = is_known ? limits.x : 0.0;
  camera[kCameraUnknowns + 1] = is_known ? limits.y : 0.0;
}
