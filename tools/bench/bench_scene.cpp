#include "tools/bench/bench_scene.h"

#include <cmath>

#include "runtime/core/pixel.h"

namespace warplut {

BenchScene::BenchScene(const BenchSceneOptions& options)
    : options_(options),
      color_(options.width, options.height, options.format),
      depth_(options.width, options.height, PixelFormat::kR32F),
      motion_(options.width, options.height) {
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) FillPixel(x, y);
  }
}

RenderedFrame BenchScene::Rendered(int index) const {
  constexpr float kJitter[4] = {-0.25f, 0.25f, 0.0f, -0.375f};
  return {
      color_.view(), depth_.view(), motion_.view(), kJitter[index % 4], kJitter[(index + 1) % 4],
      false};
}

DisplayedFrame BenchScene::Displayed() const {
  return {color_.view(), depth_.view(), motion_.view(), false};
}

void BenchScene::FillPixel(int x, int y) {
  const auto fx = static_cast<float>(x);
  const auto fy = static_cast<float>(y);
  const MutableImageView color = color_.view();
  const float white = ChannelScale(color.format);
  for (int c = 0; c < 4; ++c) {
    const float wave =
        std::sin(0.31f * fx + 0.17f * fy + static_cast<float>(c)) + std::sin(1.3f * fx - 0.9f * fy);
    StoreChannel(color.format, white * (0.5f + 0.2f * wave), color.At(x, y), c);
  }
  const float across = std::remainder(fx, 160.0f);
  const float down = std::remainder(fy, 160.0f);
  const bool disc = across * across + down * down < 900;
  depth_.view().Row<float>(y)[x] = disc ? 0.05f : 0.3f + 0.0005f * fy;

  const float scale = options_.output_scale;
  const float ox = scale * fx;
  const float oy = scale * fy;
  const float size = disc && options_.discs_part && !options_.uniform ? -1 / scale : 1 / scale;
  float* m = motion_.view().Row(y) + 2 * x;
  m[0] = size * (options_.uniform ? 3.37f : 5.3f * std::sin(0.003f * ox + 0.002f * oy));
  m[1] = size * (options_.uniform ? -1.61f : 4.1f * std::cos(0.002f * ox - 0.004f * oy));
}

double FlippedShare(const ImageView& a, const ImageView& b, float bound) {
  const float largest = bound * ChannelScale(a.format) / 255.0f;
  std::int64_t flipped = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      float worst = 0;
      for (int c = 0; c < Channels(a.format); ++c) {
        worst = std::max(worst, std::abs(LoadChannel(a.format, a.At(x, y), c) -
                                         LoadChannel(b.format, b.At(x, y), c)));
      }
      flipped += worst > largest;
    }
  }
  return static_cast<double>(flipped) / (static_cast<double>(a.width) * a.height);
}

}  // namespace warplut
