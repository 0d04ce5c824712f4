// Bands of rows of an image, in buffers that hold no more than a band.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/image_buffer.h"
#include "runtime/motion_tiles.h"

namespace warplut::generation {

// Rows that go through the passes together, in buffers that stay in the cache.
inline constexpr int kBandRows = kTileHeight;

// What one worker needs for one band.
struct BandBuffers {
  explicit BandBuffers(int width)
      : color0(static_cast<std::size_t>(width) * BytesPerPixel(PixelFormat::kRgba32F), kBandRows),
        color1(static_cast<std::size_t>(width) * BytesPerPixel(PixelFormat::kRgba32F), kBandRows),
        from0(width, kBandRows),
        from1(width, kBandRows) {}

  std::size_t bytes() const {
    return color0.size() + color1.size() + from0.bytes() + from1.bytes();
  }

  RowBuffer color0, color1;
  MotionBuffer from0, from1;
};

// Rows [first, last) of an image that has no others: its views keep the coordinates of the whole image, and nothing but these rows
// may be touched through them.
struct Band {
  int first, last;

  MutableImageView Image(const RowBuffer& rows, PixelFormat format, int width) const {
    const std::ptrdiff_t stride = std::ptrdiff_t{width} * BytesPerPixel(format);
    return {RowZero(rows.data(), stride), width, last, stride, format};
  }
  MutableMotionView Motion(MotionBuffer& rows) const {
    MutableMotionView view = rows.view();
    view.xy = RowZero(view.xy, view.stride);
    view.height = last;
    return view;
  }

 private:
  // Where row 0 would lie; an integer on the way, as no such row exists.
  template <class T>
  T* RowZero(T* rows, std::ptrdiff_t stride) const {
    return reinterpret_cast<T*>(reinterpret_cast<std::uintptr_t>(rows) -
                                static_cast<std::uintptr_t>(stride * first));
  }
};

}  // namespace warplut::generation
