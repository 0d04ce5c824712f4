#include "tests/stability/cases/history/history_loop.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "luts/certificate/gain.h"
#include "runtime/core/pixel.h"
#include "runtime/image_buffer.h"
#include "runtime/motion/motion_split.h"

namespace warplut {
namespace {

// Copies of the torus around it: two texels of motion and the taps of the filter.
constexpr int kApron = 4;

// What looked-up weights may differ by from those of the table, summed over the taps
// (luts/table.h).
constexpr double kWeightRounding = kTaps * kTaps * 0x1p-22;

// The largest value that the loop is judged up to: beyond, the roundings below do not hold.
constexpr double kLargestJudged = 4;

// The largest rounding of one store of a value up to kLargestJudged, and of one warp.
double Rounding(PixelFormat format) {
  switch (format) {
    case PixelFormat::kRgba8:
      return 0.5 / 255;
    case PixelFormat::kRgba16F:
      return 0x1p-10;
    case PixelFormat::kRgba32F:
    case PixelFormat::kR32F:
      break;
  }
  return kLargestJudged * 0x1p-24;
}

class Torus {
 public:
  explicit Torus(const LoopOptions& options)
      : options_(options),
        white_(options.format == PixelFormat::kRgba8 ? 255.0f : 1.0f),
        whole_(options.size + 2 * kApron),
        image_(whole_, whole_, options.format),
        next_(whole_, whole_, options.format),
        motion_(whole_, whole_) {
    const MutableMotionView motion = motion_.view();
    for (int y = 0; y < whole_; ++y) {
      for (int x = 0; x < whole_; ++x) {
        motion.Row(y)[2 * x] = options.motion_x;
        motion.Row(y)[2 * x + 1] = options.motion_y;
      }
    }
  }

  void Warp() {
    warplut::Warp(image_.view(), motion_.view(), options_.warp, next_.view());
    std::swap(image_, next_);
  }

  // x <- x + share (values - x), and the copies around it.
  void Blend(double share, std::span<const double> values) {
    const MutableImageView view = image_.view();
    const double* value = values.data();
    for (int y = kApron; y < kApron + options_.size; ++y) {
      for (int x = kApron; x < kApron + options_.size; ++x) {
        const double before = Get(view, x, y);
        Set(view, x, y, before + share * (*value++ - before));
      }
    }
    CopyAround();
  }

  void CopyAround() {
    const MutableImageView view = image_.view();
    const auto pixel = static_cast<std::size_t>(BytesPerPixel(view.format));
    const int last = kApron + options_.size;  // the first column or row beyond
    for (int y = kApron; y < last; ++y) {
      std::memcpy(view.At(0, y), view.At(options_.size, y), kApron * pixel);
      std::memcpy(view.At(last, y), view.At(kApron, y), kApron * pixel);
    }
    for (int k = 0; k < kApron; ++k) {
      const auto row = static_cast<std::size_t>(whole_) * pixel;
      std::memcpy(view.At(0, k), view.At(0, k + options_.size), row);
      std::memcpy(view.At(0, last + k), view.At(0, kApron + k), row);
    }
  }

  struct State {
    double deviation = 0;  // root mean square of the difference from the centre
    double mean = 0;
    double largest = 0;  // magnitude
  };

  State Measure() const {
    double squares = 0, sum = 0, largest = 0;
    for (int y = 0; y < options_.size; ++y) {
      for (int x = 0; x < options_.size; ++x) {
        const double value = Get(image_.view(), x + kApron, y + kApron);
        squares += (value - options_.center) * (value - options_.center);
        sum += value;
        largest = std::max(largest, std::abs(value));
      }
    }
    const double pixels = static_cast<double>(options_.size) * options_.size;
    return {std::sqrt(squares / pixels), sum / pixels, largest};
  }

 private:
  double Get(const ImageView& view, int x, int y) const {
    return static_cast<double>(LoadChannel(view.format, view.At(x, y), 0)) / white_;
  }

  void Set(const MutableImageView& view, int x, int y, double value) const {
    for (int c = 0; c < 4; ++c) {
      StoreChannel(view.format, static_cast<float>(value) * white_, view.At(x, y), c);
    }
  }

  const LoopOptions& options_;
  float white_;
  int whole_;
  ImageBuffer image_, next_;
  MotionBuffer motion_;
};

double Deviation(std::span<const double> values, double center) {
  double squares = 0;
  for (const double value : values) squares += (value - center) * (value - center);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

LoopResult RunLoop(const LoopOptions& options) {
  Torus torus(options);
  std::vector<double> values(static_cast<std::size_t>(options.size) *
                             static_cast<std::size_t>(options.size));
  options.first(0, values);
  torus.Blend(1, values);
  const double store = Rounding(options.format);
  // Codes are summed exactly; float kernels keep to their bound. Weights that do not quite sum to 1
  // change the constant c.
  const double warp = store + kWeightRounding * options.center +
                      (options.format == PixelFormat::kRgba8
                           ? 0.0
                           : kLargestJudged * static_cast<double>(kWarpFloatBound));
  LoopResult result;
  Torus::State state = torus.Measure();
  const double mean = state.mean;
  result.first = state.deviation;
  double bound = result.first;
  for (int frame = 1; frame <= options.frames; ++frame) {
    torus.Warp();
    bound = (1 - options.blend) * (options.gain * bound + warp);
    if (options.blend > 0) {
      options.input(frame, values);
      torus.Blend(options.blend, values);
      bound += options.blend * Deviation(values, options.center) + store;
    } else {
      torus.CopyAround();
    }
    state = torus.Measure();
    result.finite = std::isfinite(state.deviation);
    result.last = state.deviation;
    if (!result.finite) break;
    if (result.judged < frame - 1 || state.largest > kLargestJudged) continue;
    result.worst_ratio = std::max(result.worst_ratio, state.deviation / bound);
    result.drift = std::max(result.drift, std::abs(state.mean - mean));
    result.judged = frame;
  }
  return result;
}

double GainOfMotion(const WarpOptions& warp, float motion_x, float motion_y) {
  const Weights<float> looked_up =
      FilterWeights(warp, SplitMotion(motion_x).offset, SplitMotion(motion_y).offset);
  Weights<double> weights;
  std::copy(looked_up.begin(), looked_up.end(), weights.begin());
  return MaxGain(weights).gain + kWeightRounding;
}

}  // namespace warplut
