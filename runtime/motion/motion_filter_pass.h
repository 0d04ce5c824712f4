// What the vector code of the motion filter works on.
#pragma once

#include <array>

#include "runtime/image_view.h"

namespace warplut {

struct MotionFilterPass {
  ImageView depth;
  MotionView motion;
  MutableMotionView out;
  std::array<float, 11> c{};  // of CameraMotion
  float unit = 0;             // one pixel, in units of half the width
  float first_u = 0;          // position of pixel (0, 0)
  float first_v = 0;
  float limit_x = 0;  // pixels
  float limit_y = 0;
};

}  // namespace warplut
