#include <algorithm>
#include <array>
#include <cstring>

#include "runtime/core/pixel.h"
#include "runtime/float_environment.h"
#include "runtime/motion/motion_split.h"
#include "runtime/warp.h"
#include "runtime/warp/tap_polynomials.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

struct Rgba {
  std::array<float, 4> c;
};

Rgba operator*(float w, const Rgba& t) {
  return {{w * t.c[0], w * t.c[1], w * t.c[2], w * t.c[3]}};
}

Rgba operator+(const Rgba& a, const Rgba& b) {
  return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2], a.c[3] + b.c[3]}};
}

// A pixel as four floats; the missing channels of a single one are zero.
Rgba LoadPixel(const ImageView& image, int x, int y) {
  Rgba texel{};
  for (int c = 0; c < Channels(image.format); ++c) {
    texel.c[c] = LoadChannel(image.format, image.At(x, y), c);
  }
  return texel;
}

}  // namespace

void WarpReferencePixels(const WarpJob& job, const TileRect& pixels) {
  const ImageView& history = job.history;
  const MutableImageView& out = job.out;
  const int last_x = history.width - 1;
  const int last_y = history.height - 1;
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int x = pixels.x0; x < pixels.x1; ++x) {
      const auto& [whole_x, split_dx] = SplitMotion(job.motion.Row(y)[2 * x]);
      const auto& [whole_y, split_dy] = SplitMotion(job.motion.Row(y)[2 * x + 1]);
      int tx = SampledTexel(x, whole_x, history.width);
      int ty = SampledTexel(y, whole_y, history.height);
      float dx = split_dx;
      float dy = split_dy;
      if (job.IsPrefiltered()) {
        MoveInside(history.width, tx, dx);
        MoveInside(history.height, ty, dy);
      }
      if (dx == 0 && dy == 0) {
        std::memcpy(out.At(x, y),
                    job.samples.At(std::clamp(tx, 0, last_x), std::clamp(ty, 0, last_y)),
                    BytesPerPixel(out.format));
        continue;
      }
      const Footprint footprint = FootprintOf(job.options);
      std::array<Rgba, kWeights> texels;
      for (const int k : TapsOf(footprint)) {
        texels[k] = LoadPixel(history, std::clamp(tx + TapX(k), 0, last_x),
                              std::clamp(ty + TapY(k), 0, last_y));
      }
      const Rgba value = ApplyWeights(footprint, FilterWeights(job.options, dx, dy), texels);
      for (int c = 0; c < Channels(out.format); ++c) {
        StoreChannel(out.format, value.c[c], out.At(x, y), c);
      }
    }
  }
}

void WarpReference(const ImageView& history, const MotionView& motion, const WarpOptions& options,
                   const MutableImageView& out) {
  const FloatEnvironment environment;
  WarpReferencePixels({history, motion, options, out}, {0, 0, out.width, out.height});
}

void WarpReference(const PrefilteredImage& history, const MotionView& motion,
                   const WarpOptions& options, const MutableImageView& out) {
  const FloatEnvironment environment;
  WarpReferencePixels({history, motion, options, out}, {0, 0, out.width, out.height});
}

Weights<float> FilterWeights(const WarpOptions& options, float dx, float dy) {
  const FloatEnvironment environment;
  const Filter filter = FilterOf(options);
  if (filter == Filter::kLut) return options.table->At(dx, dy, LookupOf(options));
  const float parameter = ParameterOf(options);
  return Separable(FilterTaps(filter, parameter, dx), FilterTaps(filter, parameter, dy));
}

}  // namespace warplut
