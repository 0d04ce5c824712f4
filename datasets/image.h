// An image of the offline tools: float, interleaved, tightly packed.
//
// Row 0 is at the top, x right, y down; the centre of pixel (x, y) is at (x + 0.5, y + 0.5). Value
// c of that pixel is at (y * width + x) * channels + c.
#pragma once

#include <cstddef>
#include <vector>

namespace warplut {

struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> data;

  Image() = default;
  Image(int w, int h, int c)
      : width(w), height(h), channels(c), data(static_cast<std::size_t>(w) * h * c) {}

  bool empty() const { return data.empty(); }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
  std::size_t Index(int x, int y, int c = 0) const {
    return (static_cast<std::size_t>(y) * width + x) * channels + c;
  }
  float& at(int x, int y, int c = 0) { return data[Index(x, y, c)]; }
  float at(int x, int y, int c = 0) const { return data[Index(x, y, c)]; }
};

}  // namespace warplut
