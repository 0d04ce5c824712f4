// From the values of a depth or motion file to the convention of datasets/frame.h, and back.
//
// Packed (rgba8-base255): with bytes R, G, B, A, v = (R 255^3 + G 255^2 + B 255 + A) / 255^4, in
// [0, 1 + 1/254); every multiple of 255^-4 from 0 to 1 has one such code with G, B, A < 255. Both
// encodings: value = scale v + bias.
//
// Depth d = view depth / far, from the value z with near n and far f:
//   linear            d = z / f
//   forward           d = n / (f - z (f - n))         z = 0 at n, 1 at f
//   reversed          d = n / (n + z (f - n))         z = 1 at n, 0 at f
//   reversed, f = inf d = 1 / z                       in units of n, as there is no f; +inf at
//                                                     z = 0
// z of the hyperbolic kinds is clamped to [0, 1] where it is outside by at most kHyperbolicSlack,
// the most that a packed code can exceed 1, and refused beyond.
//
// Motion m in pixels of a w x h grid, from the value v: m = v s with s = 1 (pixels), (w, h) (uv) or
// (w/2, h/2) (ndc); y is negated where it is stored upwards, and both where motion is stored from
// current to previous.
//
// Computed in double, rounded to float once. Throw Error with a sentence that begins with `what` (a
// file's name) and names the pixel. No threads, no state.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "datasets/image.h"
#include "datasets/sequence/stream.h"

namespace warplut {

inline constexpr double kHyperbolicSlack = 1.0 / 254;

// The code of v in [0, 1], nearest; the value of a code.
std::array<std::uint8_t, 4> PackRgba8Base255(double v);
double UnpackRgba8Base255(const std::array<std::uint8_t, 4>& code);

// `stored`: 1 channel (kFloat) or 4 (packed, bytes / 255). Refused: NaN, negative depth, infinity
// but +infinity of linear float depth.
Image DecodeDepth(const Image& stored, const DepthStream& stream, const std::string& what);

// The inverse: what DecodeDepth would read `depth` from. Depth beyond far, infinity too, is stored
// as far where the kind is hyperbolic or the encoding is packed and depth nearer than near as near
// where hyperbolic. Refused: NaN, negative depth, and values outside [0, 1] of a packed code.
Image EncodeDepth(const Image& depth, const DepthStream& stream, const std::string& what);

// Component c (0: x, 1: y) of motion from `stored`, 1 channel or 4 as above, to channel c of
// `motion`, which has the size of `stored` and 2 channels. Where the stream says what is invalid,
// NaN stands for a component that is NaN, infinite or one of its values (within 1e-6 of the larger
// of 1 and the value, so that integer codes hit); otherwise NaN and infinity are refused.
void DecodeMotion(const Image& stored, const MotionStream& stream, int c, const std::string& what,
                  Image* motion);

// No motion, (0, 0), at every pixel of which a component is NaN.
void ClearInvalid(Image* motion);

// The inverse, of channel c of `motion`. Refused: NaN, infinity, and values outside [0, 1] of a
// packed code.
Image EncodeMotion(const Image& motion, const MotionStream& stream, int c, const std::string& what);

}  // namespace warplut
