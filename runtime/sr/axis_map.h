// Where the pixels of the output grid and the samples of the render grid lie in each other's grid,
// for one axis of one frame.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace warplut {

// One axis of the render grid of the frame before.
struct AxisBefore {
  int render = 1;
  float inverse_scale = 1;
  float jitter = 0;
};

// Positions are counted from the centre of the first pixel. An output pixel x lies at
// (x + 1/2) / s - 1/2 - jitter among the samples, a sample i at (i + 1/2 + jitter) s - 1/2 among
// the output pixels, s = output / render.
class AxisMap {
 public:
  AxisMap() = default;
  AxisMap(int render, int output)
      : render_(render),
        output_(output),
        cell_(Padded(output)),
        nearest_(Padded(output)),
        fraction_(Padded(output)),
        offset_(Padded(output)),
        texel_(Padded(render)),
        share_(Padded(render)) {}

  int render() const { return render_; }
  int output() const { return output_; }
  float scale() const { return static_cast<float>(static_cast<double>(output_) / render_); }
  float inverse_scale() const { return static_cast<float>(static_cast<double>(render_) / output_); }
  float jitter() const { return jitter_; }
  AxisBefore AsBefore() const { return {render_, inverse_scale(), jitter_}; }

  // As if made for so many samples, at most as many as those of the constructor; the jitter is to
  // be set again.
  void SetRender(int render) { render_ = render; }

  void SetJitter(float jitter) {
    jitter_ = jitter;
    const double scale = static_cast<double>(output_) / render_;
    for (int x = 0; x < static_cast<int>(cell_.size()); ++x) {
      const double u = (x + 0.5) / scale - 0.5 - jitter;
      const double inside = std::clamp(u, 0.0, static_cast<double>(render_ - 1));
      cell_[x] = static_cast<int>(inside);
      fraction_[x] = static_cast<float>(inside - cell_[x]);
      nearest_[x] = static_cast<int>(inside + 0.5);
      offset_[x] = static_cast<float>(u - nearest_[x]);
    }
    for (int i = 0; i < static_cast<int>(Padded(render_)); ++i) {
      const double v = (i + 0.5 + jitter) * scale - 0.5;
      const double inside = std::clamp(v, 0.0, static_cast<double>(output_ - 1));
      texel_[i] = std::min(static_cast<int>(inside), std::max(0, output_ - 2));
      share_[i] = static_cast<float>(inside - texel_[i]);
    }
  }

  // Of output pixel x: it lies between the samples cell and cell + 1, at `fraction` of the way,
  // limited to the outermost samples; nearest is the nearest sample, and x lies at
  // nearest + offset, not limited.
  const int* cell() const { return cell_.data(); }
  const float* fraction() const { return fraction_.data(); }
  const int* nearest() const { return nearest_.data(); }
  const float* offset() const { return offset_.data(); }

  // Of sample i: it lies between the output pixels texel and texel + 1, at `share` of the way,
  // limited to the outermost pixels; texel + 1 is in the image unless that has one pixel.
  const int* texel() const { return texel_.data(); }
  const float* share() const { return share_.data(); }

  std::size_t bytes() const { return (cell_.size() * 4 + texel_.size() * 2) * sizeof(float); }

 private:
  // Whole vectors can be read.
  static std::size_t Padded(int size) { return (static_cast<std::size_t>(size) + 15) / 16 * 16; }

  int render_ = 0;
  int output_ = 0;
  float jitter_ = 0;
  std::vector<int> cell_, nearest_;
  std::vector<float> fraction_, offset_;
  std::vector<int> texel_;
  std::vector<float> share_;
};

}  // namespace warplut
