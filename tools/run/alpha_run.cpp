#include "tools/run/alpha_run.h"

#include <algorithm>
#include <utility>

#include "train/replay/image_views.h"

namespace warplut {
namespace {

constexpr float kOpaque = 65535;

// The clip with its alpha in the place of its colour while the object lives.
class AlphaAsColor {
 public:
  AlphaAsColor(Clip& clip, Streams alpha)
      : clip_(clip), of_reference_(alpha == Streams::kReferenceAlpha), encoding_(clip.encoding) {
    clip_.encoding = ColorEncoding::kDisplay;
    Swap();
  }
  ~AlphaAsColor() {
    clip_.encoding = encoding_;
    Swap();
  }
  AlphaAsColor(const AlphaAsColor&) = delete;
  AlphaAsColor& operator=(const AlphaAsColor&) = delete;

 private:
  void Swap() {
    for (ClipFrame& frame : clip_.frames) {
      if (of_reference_) {
        std::swap(frame.reference, frame.reference_alpha);
      } else {
        std::swap(frame.color, frame.alpha);
      }
    }
  }

  Clip& clip_;
  const bool of_reference_;
  const ColorEncoding encoding_;
};

}  // namespace

Image ToImage(const ShownAlpha& alpha, int width, int height) {
  Image image(width, height, 1);
  std::transform(alpha.begin(), alpha.end(), image.data.begin(),
                 [](std::uint16_t value) { return static_cast<float>(value) / kOpaque; });
  return image;
}

Streams AlphaStreamOf(const Sequence& sequence, const MethodInfo& method) {
  const Streams available = AvailableStreams(sequence);
  const bool from_references = Contains(NeededStreams(method, available), Streams::kReference);
  return available & (from_references ? Streams::kReferenceAlpha : Streams::kAlpha);
}

std::vector<ShownAlpha> RunAlpha(Clip& clip, Streams alpha, const ModeRunOptions& options,
                                 Executor& executor, const std::function<void()>& on_frame) {
  const AlphaAsColor swapped(clip, alpha);
  std::vector<ShownAlpha> alphas;
  RunMode(clip, options, executor, [&](const ShownFrame& shown) {
    const Image grey = ToImage(shown.image);
    ShownAlpha& of_frame = alphas.emplace_back(grey.pixels());
    for (std::size_t i = 0; i < of_frame.size(); ++i) {
      const float share = std::clamp(grey.data[3 * i], 0.0F, 1.0F);
      of_frame[i] = static_cast<std::uint16_t>(share * kOpaque + 0.5F);
    }
    on_frame();
  });
  return alphas;
}

}  // namespace warplut
