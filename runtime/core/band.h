// Bands of rows: how work on an image is handed out, and buffers that hold no more than a band.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/motion_tiles.h"

namespace warplut {

// Rows that go through the passes together, in buffers that stay in the cache: one row of motion
// tiles.
inline constexpr int kBandRows = kTileHeight;

// Rows [first, last) of an image. The views of a buffer that holds no others keep the coordinates
// of the whole image, and nothing but these rows may be touched through them.
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

// Calls work(band, scratch) for the bands of `band_rows` rows that `rows` rows fall into, each
// once. `scratch` has one entry for each of the executor's threads; no two pieces that run at the
// same time get the same one.
template <class Scratch, class Work>
void ForEachBand(Executor& executor, int rows, int band_rows, std::vector<Scratch>& scratch,
                 const Work& work) {
  const int count = TileCount(rows, band_rows);
  std::atomic<int> next = 0;
  executor.ForEach(static_cast<int>(scratch.size()), [&](int worker) {
    for (int i = next++; i < count; i = next++) {
      work(Band{i * band_rows, std::min((i + 1) * band_rows, rows)},
           scratch[static_cast<std::size_t>(worker)]);
    }
  });
}

}  // namespace warplut
