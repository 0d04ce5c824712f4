// Where a pixel of frame 1 is in the generated frame.
//
// m1 is its motion from frame 0 to 1, m0 that from frame -1 to 0. One axis at a time; T is float,
// double or a derivative type. docs/GENERATION.md derives the formulas.
#pragma once

namespace warplut::generation {

// Uniformly accelerated on the screen; m0 = m1 makes the motion linear. From its position in frame
// 1 to that at time alpha between frames 0 and 1. Source: Mob-FGSR, supplement, equations 1, 2, 14
// and 15.
template <class T>
constexpr T InterpolatedDisplacement(T m1, T m0, T alpha) {
  return T(0.5) * alpha * (m1 + m0) + T(0.5) * alpha * alpha * (m1 - m0) - m1;
}

// The same to time alpha after frame 1.
template <class T>
constexpr T ExtrapolatedDisplacement(T m1, T m0, T alpha) {
  return T(0.5) * alpha * (T(3) * m1 - m0) + T(0.5) * alpha * alpha * (m1 - m0);
}

// A path in homogeneous coordinates h = (x z, y z, z), quadratic in time through frames -1, 0 and
// 1, z being linear in time. `ratio` is z0 / z1, the depth in frame 0 over that in frame 1; ratio =
// 1 gives the displacements above. `time` is alpha between frames 0 and 1, 1 + alpha after frame 1.
//
//   h(t) = t (t - 1) / 2 h(-1) + (1 - t^2) h(0) + t (t + 1) / 2 h(1),  z(-1) = 2 z0 - z1
template <class T>
struct PerspectivePath {
  T time, ratio;

  // Depths over z1, in frame -1 and in the generated frame. A point with a depth of 0 or less is
  // not in front of the camera.
  constexpr T DepthBefore() const { return T(2) * ratio - T(1); }
  constexpr T Depth() const { return ratio + time * (T(1) - ratio); }

  // From the position in frame 1 to that in the generated frame. `gate` tells how far m0 counts:
  // with 0 it is what makes h linear in time, through frames 0 and 1.
  constexpr T Displacement(T m1, T m0, T gate) const {
    const T now = T(1) - time * time;
    const T before = T(0.5) * time * (time - T(1));
    const T steady = T(2) * ratio * m1;
    const T moved = steady + gate * (DepthBefore() * (m1 + m0) - steady);
    return -(now * (ratio * m1) + before * moved) / Depth();
  }
};

}  // namespace warplut::generation
