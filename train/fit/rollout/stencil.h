// A warp by one displacement for the whole image, and its adjoint: the inner loop of the training.
#pragma once

#include <cstddef>
#include <vector>

#include "luts/contract.h"

namespace warplut {

// A plane with a border of kBorder pixels on every side, all rows of one stride. Pixel (x, y), also
// of the border, is at origin()[y * stride() + x].
class BorderedPlane {
 public:
  static constexpr int kBorder = 6;

  BorderedPlane(int width, int height)
      : width_(width),
        height_(height),
        stride_((width + 2 * kBorder + kLanes - 1) / kLanes * kLanes + kLanes),
        data_(static_cast<std::size_t>(stride_) * (height + 2 * kBorder) + kLanes) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  float* origin() { return data_.data() + kBorder * stride_ + kBorder; }
  const float* origin() const { return data_.data() + kBorder * stride_ + kBorder; }
  float* row(int y) { return origin() + y * stride_; }
  const float* row(int y) const { return origin() + y * stride_; }

  void Clear() { std::fill(data_.begin(), data_.end(), 0.0f); }

 private:
  static constexpr int kLanes = 16;

  int width_;
  int height_;
  std::ptrdiff_t stride_;
  std::vector<float> data_;
};

// One warp: every pixel p becomes the sum, over the taps of the footprint, of weight k times the
// texel at p + (cell_x + TapX(k), cell_y + TapY(k)).
struct Stencil {
  int cell_x = 0;  // whole part of the sampled position, -1 or 0
  int cell_y = 0;
  Weights<float> weights{};
  Footprint footprint = Footprint::k16;
};

// How far a stencil of any footprint reads past the image: a whole part of -1 and tap -2, or tap 3.
inline constexpr int kStencilReach = 3;
// Its adjoint reads gradients as far again.
static_assert(BorderedPlane::kBorder >= 2 * kStencilReach);

// How an image goes on beyond its edges: its edge pixels repeat, or it is mirrored at the edge of
// the outermost pixels, x(-1 - i) = x(i).
enum class Border { kRepeated, kMirrored };

// The pixel 0..size - 1 that stands for pixel `i`, any integer.
int ContinuedPixel(int i, int size, Border border);

// Continues the image into the border, as far as a stencil reads.
void FillBorder(BorderedPlane& plane, Border border = Border::kRepeated);

// out = stencil of `in`, clamped to [0, 1], border filled with repeated pixels. `in` has its border
// filled; the planes are of one size and different.
void ApplyStencil(const Stencil& stencil, const BorderedPlane& in, BorderedPlane& out);

// The adjoint. `in` and `out` as after ApplyStencil; `out_gradient` is d(loss)/d(out) inside the
// image and zero in the border, and is overwritten (clamped pixels pass nothing). Writes
// d(loss)/d(in), the border, which is of kind `border`, folded back into the image and cleared, to
// `in_gradient` and adds d(loss)/d(weights) to `weight_gradient`.
void AdjointStencil(const Stencil& stencil, const BorderedPlane& in, const BorderedPlane& out,
                    BorderedPlane& out_gradient, BorderedPlane& in_gradient,
                    Weights<double>& weight_gradient, Border border = Border::kRepeated);

}  // namespace warplut
