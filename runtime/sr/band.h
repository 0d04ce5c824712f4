// Some rows of an image in a buffer that holds no others.
#pragma once

#include <cstdint>

#include "runtime/image_buffer.h"

namespace warplut {

// A view whose row `first` is the first of `rows`. Only the rows that the buffer holds may be asked for; the view's own height
// is no more than a number.
inline MutableMotionView BandMotion(MotionBuffer& rows, int first) {
  MutableMotionView view = rows.view();
  const auto address = reinterpret_cast<std::uintptr_t>(view.xy);
  view.xy = reinterpret_cast<float*>(address - static_cast<std::uintptr_t>(first * view.stride));
  view.height += first;
  return view;
}

}  // namespace warplut
