// 3D warping of a mesh of pixels (docs/METHODS.md): the centres of frame 1's pixels are vertices,
// moved by the linear displacement D. Each 2 x 2 of them is two triangles, drawn into the generated
// frame.
//
// At a pixel centre q inside of a triangle with vertices p_i + D_i and barycentric weights w_i the
// source is p = sum of w_i p_i, that is q - sum of w_i D_i. The nearest triangle wins. Triangles of
// a quad whose vertices are not alike in depth (DepthTolerance) and are more than kLeastStretch
// apart are stretched over what they uncover, and give way to all that are not. Triangles of quads
// longer than kLongestSheet are not drawn.
#pragma once

#include <cmath>
#include <cstdint>

#include "runtime/generation/motion/target_motion.h"
#include "runtime/peers/generation/linear_motion.h"
#include "runtime/peers/generation/triangle.h"

namespace warplut::peers {

// In pixels, of the box around a quad in each axis: where it is stretched, where it is torn. At
// rest a quad has 1.
inline constexpr float kLeastStretch = 1.5f;
inline constexpr float kLongestSheet = 64.0f;

// A splat key whose highest bit says that the triangle is stretched, then its depth, then
// 2 * (index of the quad's upper left pixel) + (1 for the lower right triangle).
inline constexpr SplatKey kStretched = SplatKey{1} << 63;

// The linear displacements of row y of frame 1 into `forward`, NaN where there is no motion;
// returns the rows that the quads between rows y and y + 1 reach.
RowRange MeshForwardRow(const GenerationJob& job, int y, const MutableMotionView& forward);

// Draws the quad of pixels (x, y) to (x + 1, y + 1) into the rows of `target`.
void DrawQuad(const GenerationJob& job, const MotionView& forward, const DepthTolerance& tolerance,
              int x, int y, RowRange target, const KeyView& keys);

// The motion of the generated frame's pixel (x, y). A connected surface is taken from frame 1. A
// stretched triangle is too, as it is, but with DisocclusionFill::kBackground the ground of its
// farthest corner goes on: interpolation takes it from frame 0 by the motion of the corner,
// extrapolation from frame 1, mirrored at the corner.
// Nothing drawn: the pixel of frame 1 at the same place.
TargetMotion MeshMotionAt(const GenerationJob& job, const Arrivals& arrivals, int x, int y);

}  // namespace warplut::peers
