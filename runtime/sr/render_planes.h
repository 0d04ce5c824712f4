// A rendered frame as the passes read it: planes of checked floats.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "runtime/color_encoding.h"
#include "runtime/gates.h"
#include "runtime/sr/plane.h"

namespace warplut {

struct RenderPlanes {
  RenderPlanes() = default;
  RenderPlanes(int width, int height, bool with_motion = true, bool with_reactive = false)
      : color{{width, height}, {width, height}, {width, height}} {
    if (with_reactive) reactive = Plane(width, height);
    if (!with_motion) return;
    for (Plane* plane : {&depth, &motion_x, &motion_y}) *plane = Plane(width, height);
  }

  void SetSize(int width, int height) {
    for (Plane& plane : color) plane.SetSize(width, height);
    for (Plane* plane : {&depth, &motion_x, &motion_y, &reactive}) plane->SetSize(width, height);
  }

  std::size_t bytes() const {
    return 3 * color[0].bytes() + depth.bytes() + 2 * motion_x.bytes() + reactive.bytes();
  }

  Plane color[3];  // R, G, B in [0, 1]; codes of linear HDR
  // Without rows where motion is not read.
  Plane depth;               // in [0, kFarthestDepth]
  Plane motion_x, motion_y;  // render pixels; NaN where either component is not finite
  Plane reactive;            // in [0, 1]; without rows where the mask is not read
};

inline float SanitizeDepth(float depth) {
  return depth >= 0 && depth < kFarthestDepth ? depth : kFarthestDepth;
}

// NaN is 0.
inline float SanitizeReactive(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

// Whether both components are finite.
inline bool IsFiniteMotion(float x, float y) { return IsFinite(x) && IsFinite(y); }

// (r, g, b) as blends and histories hold it.
inline void EncodeColor(ColorEncoding encoding, float (&rgb)[3]) {
  for (float& channel : rgb) {
    if (encoding == ColorEncoding::kLinearHdr) {
      channel = HdrCode(LimitHdr(channel));
    } else {
      const float finite = IsFinite(channel) ? channel : 0.0f;
      channel = std::clamp(finite, 0.0f, 1.0f);
    }
  }
}

// The way back, from [0, 1].
inline void DecodeColor(ColorEncoding encoding, float (&rgb)[3]) {
  if (encoding == ColorEncoding::kDisplay) return;
  for (float& channel : rgb) channel = HdrValue(channel);
}

}  // namespace warplut
