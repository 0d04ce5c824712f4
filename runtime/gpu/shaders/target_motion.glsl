// Motion of the generated frame's own pixels, to warp frames 0 and 1 by:
// runtime/generation/motion/target_motion.h. Before it comes generation.glsl.

// Motion from frames 0 and 1 to a pixel: the source positions are q - m.
struct TargetMotion {
  vec2 from0;
  vec2 from1;
};

uint SourceAt(ivec2 p) { return keys[2 * PixelIndex(p)]; }

// The depth of what arrived at p, beyond all others where nothing did.
float ArrivalDepth(ivec2 p) {
  uint bits = keys[2 * PixelIndex(p) + 1];
  return bits == kNoArrival ? kNoArrivalDepth : uintBitsToFloat(bits);
}

// |DepthDifference| <= T_D without its division.
bool Alike(float a, float b) {
  float absolute = DEPTH == kDepthMeasureNone       ? 2.0 * kFarthestDepth
                   : DEPTH == kDepthMeasureAbsolute ? frame.depth_threshold
                                                    : 0.0;
  float relative = DEPTH == kDepthMeasureRelative ? frame.depth_threshold : 0.0;
  precise float tolerance = absolute + relative * max(min(a, b), 1e-12);
  return abs(a - b) <= tolerance;
}

TargetMotion Arrived(uint source) {
  ivec2 p = PixelOfIndex(source);
  vec2 from1 = ForwardDisplacement(p);
  precise vec2 from0 = from1 + MotionAt(motion1, p);
  return TargetMotion(from0, from1);
}

// The four 2 x 2 blocks of the 3 x 3 pixels around one, as bits in reading order.
const int kBlocks[4] = int[4](0x1B, 0x36, 0xD8, 0x1B0);

// Pixel k, in reading order, of the 3 x 3 around p.
ivec2 Neighbour(ivec2 p, int k) { return p + ivec2(k % 3 - 1, k / 3 - 1); }

// The mean motion of the foreground around a gap; false if p is none.
bool Gap(ivec2 p, out TargetMotion motion) {
  motion = TargetMotion(vec2(0.0), vec2(0.0));
  float center = ArrivalDepth(p);
  float nearest = center;
  int alike = 0;
  for (int k = 0; k < 9; ++k) {
    float depth = ArrivalDepth(clamp(Neighbour(p, k), ivec2(0), frame.output_size - 1));
    if (Alike(center, depth)) alike |= 1 << k;
    nearest = min(nearest, depth);
  }
  for (int block = 0; block < 4; ++block) {
    if ((alike & kBlocks[block]) == kBlocks[block]) return false;
  }
  if (Alike(center, nearest)) return false;
  vec2 sum0 = vec2(0.0), sum1 = vec2(0.0);
  float count = 0.0;
  for (int k = 0; k < 9; ++k) {
    ivec2 q = Neighbour(p, k);
    if (!Contains(q)) continue;
    float depth = ArrivalDepth(q);
    if (depth == kNoArrivalDepth || !Alike(depth, nearest)) continue;
    TargetMotion neighbour = Arrived(SourceAt(q));
    sum0 += neighbour.from0;
    sum1 += neighbour.from1;
    count += 1.0;
  }
  float share = 1.0 / count;
  motion = TargetMotion(share * sum0, share * sum1);
  return true;
}

// Steps of `direction` from p that stay in [0, size).
int Reach(int p, int direction, int size) {
  return direction < 0 ? p : direction > 0 ? size - 1 - p : kBackgroundReach;
}

// The source of the farthest of the first arrivals in 8 directions; kNoArrival if there are none.
// Of equally far ones the first direction counts.
uint Background(ivec2 p) {
  const ivec2 kDirections[8] =
      ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1),
               ivec2(1, -1), ivec2(-1, -1));
  uint farthest = kNoArrival;
  float most = -1.0;
  for (int k = 0; k < 8; ++k) {
    ivec2 direction = kDirections[k];
    int reach = min(kBackgroundReach, min(Reach(p.x, direction.x, frame.output_size.x),
                                          Reach(p.y, direction.y, frame.output_size.y)));
    for (int step_ = 1; step_ <= reach; ++step_) {
      ivec2 q = p + step_ * direction;
      uint source = SourceAt(q);
      if (source == kNoArrival) continue;
      float depth = ArrivalDepth(q);
      if (depth > most) {
        most = depth;
        farthest = source;
      }
      break;
    }
  }
  return farthest;
}

// From frame 0 to the generated frame, and to frame 1.
struct SteadyMotion {
  vec2 to_generated;
  vec2 to_frame1;
};

// A pixel of frame 0 that goes on steadily in homogeneous coordinates; `loss` is the depth that it
// loses from frame to frame.
SteadyMotion GoOn(vec2 m0, float z0, float loss) {
  precise float before = z0 + loss;
  precise vec2 to_generated = frame.alpha * (before / (z0 - frame.alpha * loss)) * m0;
  precise vec2 to_frame1 = (before / (z0 - loss)) * m0;
  return SteadyMotion(to_generated, to_frame1);
}

// The pixel of frame 0 that arrives at p as it goes on, by fixed-point steps from the motion of the
// background; false if they end nowhere.
bool FoundInFrame0(ivec2 p, uint background, TargetMotion arrived, out TargetMotion motion) {
  motion = arrived;
  ivec2 b = PixelOfIndex(background);
  vec2 m1 = MotionAt(motion1, b);
  SurfaceBefore surface = FindSurfaceBefore(b, m1);
  if (!(surface.gate > 0.0)) return false;
  float depth = NotZero(DepthAt(depth1, b));
  precise float loss = depth * (surface.ratio - 1.0);
  precise float depth_before = depth * surface.ratio;
  precise float least = 2.0 * abs(loss);
  if (!(depth_before > least)) return false;
  SteadyMotion steady = GoOn(surface.motion, depth_before, loss);
  precise vec2 bend0 = arrived.from0 - steady.to_generated;
  precise vec2 bend1 = m1 - steady.to_frame1;
  precise vec2 from0 = arrived.from0;
  precise vec2 whole = m1;
  precise vec2 off = vec2(0.0);
  for (int step_ = 0; step_ < kSearchSteps; ++step_) {
    ivec2 p0 = NearestPixel(p, -from0);
    if (p0.x < 0) return false;
    vec2 m0 = MotionAt(motion0, p0);
    float z0 = NotZero(DepthAt(depth0, p0));
    if (!IsFiniteVector(m0) || !(z0 > least)) return false;
    SteadyMotion here = GoOn(m0, z0, loss);
    precise vec2 next = here.to_generated + bend0;
    off = abs(next - from0);
    from0 = next;
    whole = here.to_frame1 + bend1;
  }
  if (!(max(off.x, off.y) <= kSearchClosure)) return false;
  precise vec2 from1 = from0 - whole;
  motion = TargetMotion(from0, from1);
  return true;
}

// The motion of a pixel at which nothing arrived.
TargetMotion Disocclusion(ivec2 p) {
  if (INTERPOLATES || FILL == kDisocclusionFillBackground) {
    uint background = Background(p);
    if (background == kNoArrival) return TargetMotion(vec2(0.0), vec2(0.0));
    TargetMotion arrived = Arrived(background);
    TargetMotion found;
    bool shown = INTERPOLATES && FollowsPerspective() && FoundInFrame0(p, background, arrived, found);
    return shown ? found : arrived;
  }
  vec2 own = FILL == kDisocclusionFillOwnMotion ? ForwardDisplacement(p) : vec2(0.0);
  return TargetMotion(vec2(0.0), IsFiniteVector(own) ? own : vec2(0.0));
}

// Without splatting: the pixel at the same place of frame 1 is taken to arrive.
TargetMotion OwnMotion(ivec2 p) {
  TargetMotion motion = Arrived(uint(PixelIndex(p)));
  if (IsFiniteVector(motion.from1)) return motion;
  return TargetMotion(vec2(0.0), vec2(0.0));
}

TargetMotion TargetMotionAt(ivec2 p) {
  if (!SPLAT) return OwnMotion(p);
  TargetMotion motion;
  if (REFINE && Gap(p, motion)) return motion;
  uint source = SourceAt(p);
  return source != kNoArrival ? Arrived(source) : Disocclusion(p);
}
