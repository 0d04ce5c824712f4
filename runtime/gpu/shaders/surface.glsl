// Step 1 of runtime/super_resolution.h: motion and depth of an output pixel. Before it come
// super_resolution.glsl and the samplers `depth` and `motion`.

// What is seen at a point; motion in render pixels.
struct Surface {
  float depth;
  vec2 motion;
};

Surface SurfaceOf(ivec2 p) { return Surface(LoadDepth(depth, p), LoadMotion(motion, p)); }

// The nearest to the camera of the 3 x 3 samples around p; of equal ones the middle one, then the
// first in reading order.
Surface NearestSurface(ivec2 p) {
  float least = LoadDepth(depth, p);
  ivec2 at = p;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      float z = LoadDepth(depth, p + ivec2(di, dj));
      if (z < least) {
        least = z;
        at = p + ivec2(di, dj);
      }
    }
  }
  return Surface(least, LoadMotion(motion, at));
}

// Bilinear inside a surface; at its edges the nearest surface.
Surface EdgeAwareSurface(ivec2 cell, vec2 t, ivec2 nearest) {
  Surface a = SurfaceOf(cell), b = SurfaceOf(cell + ivec2(1, 0));
  Surface c = SurfaceOf(cell + ivec2(0, 1)), d = SurfaceOf(cell + ivec2(1, 1));
  float least = min(min(a.depth, b.depth), min(c.depth, d.depth));
  float greatest = max(max(a.depth, b.depth), max(c.depth, d.depth));
  float most_motion = max(max(a.motion.x, b.motion.x), max(c.motion.x, d.motion.x));
  bool edge = most_motion >= kNoMotion ||
              (greatest - least) / max(least, 1e-12) > kSurfaceStep;
  if (edge) return NearestSurface(nearest);
  vec3 left = mix(vec3(a.depth, a.motion), vec3(c.depth, c.motion), t.y);
  vec3 right = mix(vec3(b.depth, b.motion), vec3(d.depth, d.motion), t.y);
  vec3 inside = left + t.x * (right - left);
  return Surface(inside.x, inside.yz);
}

Surface SurfaceAt(AxisPlace x, AxisPlace y) {
  ivec2 nearest = ivec2(x.nearest, y.nearest);
  if (MOTION == kMotionUpsamplingNearest) return SurfaceOf(nearest);
  if (MOTION == kMotionUpsamplingDilated) return NearestSurface(nearest);
  if (MOTION == kMotionUpsamplingStatic) return Surface(kFarthestDepth, vec2(0.0));
  return EdgeAwareSurface(ivec2(x.cell, y.cell), vec2(x.fraction, y.fraction), nearest);
}
