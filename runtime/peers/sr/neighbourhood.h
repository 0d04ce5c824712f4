// What the peers know of the 3 x 3 samples around an output pixel.
#pragma once

#include <algorithm>

#include "runtime/color_encoding.h"
#include "runtime/core/pixel.h"
#include "runtime/sr/passes.h"
#include "runtime/sr/reference.h"

namespace warplut::peers {

// Weights of one sample, by its distance from the pixel in render pixels.
struct SampleWeights {
  float color;
  float box;
};

// Sums over the samples nearest to the pixel and their 8 neighbours, those of the border repeated.
struct Neighbourhood {
  float weight = 0;  // of colour
  Rgb color{};
  float box_weight = 0;
  Rgb box{}, box_square{};
  Rgb low{{1, 1, 1}}, high{};  // the least and the greatest sample

  Rgb Color() const { return Scaled(color, 1.0f / weight); }
  Rgb Mean() const { return Scaled(box, 1.0f / box_weight); }
  Rgb Deviation() const {
    const Rgb mean = Mean();
    Rgb deviation;
    for (int c = 0; c < 3; ++c) {
      const float square = box_square.c[c] * (1.0f / box_weight);
      deviation.c[c] = std::sqrt(std::max(square - mean.c[c] * mean.c[c], 0.0f));
    }
    return deviation;
  }

 private:
  static Rgb Scaled(const Rgb& v, float factor) {
    return {{v.c[0] * factor, v.c[1] * factor, v.c[2] * factor}};
  }
};

// weigh(di, dj, dx, dy) is called with the place of each sample, -1 to 1, and its distance.
template <class Weigh>
Neighbourhood NeighbourhoodAt(const SrJob& job, int x, int y, const Weigh& weigh) {
  Neighbourhood n;
  const int i = job.x.nearest()[x], j = job.y.nearest()[y];
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const SampleWeights w = weigh(di, dj, job.x.offset()[x] - static_cast<float>(di),
                                    job.y.offset()[y] - static_cast<float>(dj));
      n.weight += w.color;
      n.box_weight += w.box;
      for (int c = 0; c < 3; ++c) {
        const float s = job.planes.color[c].Row(j + dj)[i + di];
        n.color.c[c] += w.color * s;
        n.box.c[c] += w.box * s;
        n.box_square.c[c] += w.box * s * s;
        n.low.c[c] = std::min(n.low.c[c], s);
        n.high.c[c] = std::max(n.high.c[c], s);
      }
    }
  }
  return n;
}

// A predicted pixel with the validity of its history.
struct Predicted {
  Rgb color;
  float validity;
};

// Rows [begin, end): blend(x, y, predicted, n) with the weights of weigh(x, y) becomes history and
// output where some of the history is valid; elsewhere the prediction does.
// In linear HDR it is limited to the brightest sample, or to the code of kUnlimitedHdr if that is
// more.
template <class WeighAt, class Blend>
void UpdateRowsReference(const SrJob& job, int begin, int end, const MutableImageView& out,
                         const WeighAt& weigh, const Blend& blend) {
  const bool hdr = EncodingOf(job.options) == ColorEncoding::kLinearHdr;
  const auto load = [&](int x, int y, int c) {
    return LoadChannel(job.next.format, job.next.At(x, y), c) / ChannelScale(job.next.format);
  };
  const auto store = [](const MutableImageView& to, int x, int y, int c, float value) {
    StoreChannel(to.format, value * ChannelScale(to.format), to.At(x, y), c);
  };
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.x.output(); ++x) {
      const Predicted predicted{{{load(x, y, 0), load(x, y, 1), load(x, y, 2)}}, load(x, y, 3)};
      const Neighbourhood n = NeighbourhoodAt(job, x, y, weigh(x, y));
      const Rgb blended = blend(x, y, predicted, n);
      Rgb q = predicted.validity > 0 ? blended : predicted.color;
      for (int c = 0; c < 3; ++c) {
        if (hdr) q.c[c] = std::min(q.c[c], std::max(n.high.c[c], HdrCode(kUnlimitedHdr)));
        q.c[c] = std::clamp(q.c[c], 0.0f, 1.0f);
        store(job.next, x, y, c, q.c[c]);
      }
      store(job.next, x, y, 3, 1.0f);
      DecodeColor(EncodingOf(job.options), q.c);
      for (int c = 0; c < 3; ++c) store(out, x, y, c, q.c[c]);
      store(out, x, y, 3, 1.0f);
    }
  }
}

}  // namespace warplut::peers
