// The way of a pixel of frame 1 by the perspective motion model, line by line as in
// runtime/generation/motion/motion_model.h and surface_before.h. Before it comes generation.glsl.

// A depth that can be divided by.
float NotZero(float depth) { return max(depth, kLeastSurfaceDepth); }

// The surface of a pixel of frame 1 in frame 0, read between the pixels of frame 0.
struct SurfaceBefore {
  vec2 motion;
  float ratio;  // its depth in frame 0 over that in frame 1
  float gate;   // how far the motion counts; with 0 there is no such surface and ratio is 1
};

// Of the four pixels of frame 0 around p - m1 those count that have a finite motion and the depth
// of the anchor, of those with a weight the one whose depth is nearest to that of frame 1.
SurfaceBefore FindSurfaceBefore(ivec2 p, vec2 m1) {
  SurfaceBefore none = SurfaceBefore(m1, 1.0, 0.0);
  if (NearestPixel(p, -m1).x < 0) return none;
  ivec2 last = frame.output_size - 1;
  precise vec2 position = clamp(vec2(p) - m1, vec2(0.0), vec2(last));
  ivec2 corner = ivec2(position);
  precise vec2 f = position - vec2(corner);
  precise vec2 e = 1.0 - f;
  precise vec4 weights = vec4(e.x * e.y, f.x * e.y, e.x * f.y, f.x * f.y);
  float depth = DepthAt(depth1, p);
  vec2 motions[4];
  float depths[4];
  float anchor = kNoArrivalDepth;
  for (int k = 0; k < 4; ++k) {
    ivec2 tap = min(corner + ivec2(k & 1, k >> 1), last);
    motions[k] = MotionAt(motion0, tap);
    depths[k] = DepthAt(depth0, tap);
    if (!(weights[k] > 0.0) || !IsFiniteVector(motions[k])) continue;
    if (abs(depths[k] - depth) < abs(anchor - depth)) anchor = depths[k];
  }
  precise float total = 0.0, nearness = 0.0;
  precise vec2 sum = vec2(0.0);
  for (int k = 0; k < 4; ++k) {
    precise float tolerance = kSurfaceTolerance * min(depths[k], anchor);
    if (!IsFiniteVector(motions[k]) || !(abs(depths[k] - anchor) <= tolerance)) continue;
    total += weights[k];
    nearness += weights[k] * (NotZero(anchor) / NotZero(depths[k]));
    sum += weights[k] * motions[k];
  }
  if (!(total > 0.0)) return none;
  precise float share = 1.0 / total;
  precise float before = min(total / nearness * anchor, kFarthestDepth);
  float gate = Gate(abs(DepthDifference(before, depth)), frame.depth_threshold, frame.gate_width);
  if (!(gate > 0.0)) return none;
  precise vec2 motion = share * sum;
  precise float ratio = NotZero(before) / NotZero(depth);
  return SurfaceBefore(motion, ratio, gate);
}

// Displacement of pixel p of frame 1 with the finite motion m1; not finite where the path passes
// the camera.
vec2 PerspectiveDisplacement(ivec2 p, vec2 m1) {
  SurfaceBefore surface = FindSurfaceBefore(p, m1);
  precise float time = INTERPOLATES ? frame.alpha : 1.0 + frame.alpha;
  precise float depth = surface.ratio + time * (1.0 - surface.ratio);
  if (!(depth >= kLeastDepthRatio)) return Nowhere();
  precise float depth_before = 2.0 * surface.ratio - 1.0;
  float gate = depth_before > 0.0 ? surface.gate : 0.0;
  precise float now = 1.0 - time * time;
  precise float before = 0.5 * time * (time - 1.0);
  precise vec2 steady = 2.0 * surface.ratio * m1;
  precise vec2 moved = steady + gate * (depth_before * (m1 + surface.motion) - steady);
  precise vec2 d = -(now * (surface.ratio * m1) + before * moved) / depth;
  return IsFiniteVector(d) ? d : Nowhere();
}
