// Where a pixel of frame 1 is in the generated frame: the motion of frames -1, 0 and 1 as uniformly
// accelerated.
//
// m1 is its motion from frame 0 to 1, m0 that from frame -1 to 0; m0 = m1 makes the motion linear.
// One axis at a time; T is float, double or a derivative type. Source: Mob-FGSR, supplement,
// equations 1, 2, 14 and 15.
#pragma once

namespace warplut::generation {

// From its position in frame 1 to that at time alpha between frames 0 and 1.
template <class T>
constexpr T InterpolatedDisplacement(T m1, T m0, T alpha) {
  return T(0.5) * alpha * (m1 + m0) + T(0.5) * alpha * alpha * (m1 - m0) - m1;
}

// From its position in frame 1 to that at time alpha after frame 1.
template <class T>
constexpr T ExtrapolatedDisplacement(T m1, T m0, T alpha) {
  return T(0.5) * alpha * (T(3) * m1 - m0) + T(0.5) * alpha * alpha * (m1 - m0);
}

}  // namespace warplut::generation
