// Whether colours beside an alpha are stored as the manifest says: straight or premultiplied.
#include <fmt/format.h>

#include <algorithm>

#include "datasets/error.h"
#include "train/inspection/findings.h"

namespace warplut {
namespace {

constexpr float kPartial = 0.05F;    // pixels whose alpha is so far from 0 and 1 are looked at
constexpr float kCode = 1.5F / 255;  // rounding of 8 bits on both
constexpr int kFewestPixels = 64;    // that are partial, to tell
constexpr double kBrighter = 0.02;   // share of them that no premultiplied layer has
constexpr double kFollowAlpha =
    0.5;  // share whose brightest channel is alpha: white, premultiplied

struct LayerCounts {
  int partial = 0, brighter = 0, equal = 0;

  void Add(float alpha, float brightest) {
    if (alpha < kPartial || alpha > 1 - kPartial) return;
    ++partial;
    brighter += brightest > alpha + kCode ? 1 : 0;
    equal += brightest > alpha - kCode && brightest <= alpha + kCode ? 1 : 0;
  }
};

float Brightest(const Image& image, std::size_t pixel) {
  const float* p = image.data.data() + pixel * static_cast<std::size_t>(image.channels);
  return std::max({p[0], p[1], p[2]});
}

void AddFinding(const char* stream, AlphaKind stated, const LayerCounts& counts,
                std::vector<Finding>* findings) {
  if (counts.partial < kFewestPixels) return;
  const auto share = [&](int count) { return static_cast<double>(count) / counts.partial; };
  if (stated == AlphaKind::kPremultiplied && share(counts.brighter) > kBrighter) {
    findings->push_back(
        {"straight alpha", Severity::kWarning,
         fmt::format("{:.0f} % of the half-transparent pixels of '{}' are brighter than their "
                     "alpha, which premultiplied colour never is; \"straight\" would fit.",
                     100 * share(counts.brighter), stream)});
  }
  if (stated == AlphaKind::kStraight && share(counts.equal) > kFollowAlpha &&
      share(counts.brighter) < kBrighter) {
    findings->push_back(
        {"premultiplied alpha", Severity::kWarning,
         fmt::format("{:.0f} % of the half-transparent pixels of '{}' are as bright as their alpha "
                     "and hardly one is brighter; \"premultiplied\" would fit.",
                     100 * share(counts.equal), stream)});
  }
}

}  // namespace

std::vector<Finding> FindLayerFaults(const Sequence& sequence) {
  std::vector<Finding> findings;
  // Linear colour may be brighter than its alpha, premultiplied too.
  if (sequence.color_space == ColorSpace::kLinear) return findings;
  LayerCounts hud, alpha;
  for (const int index : {0, sequence.count / 2, sequence.count - 1}) {
    try {
      if (sequence.hud) {
        const Image layer = LoadFrame(sequence, index, Streams::kHud).hud;
        const bool straight = sequence.hud->alpha == AlphaKind::kStraight;
        for (std::size_t i = 0; i < layer.pixels(); ++i) {
          const float a = layer.data[4 * i + 3];
          hud.Add(a, straight && a > 0 ? Brightest(layer, i) / a : Brightest(layer, i));
        }
      }
      if (sequence.alpha) {
        // One by one: read together, straight colour would be multiplied.
        const Image color = LoadFrame(sequence, index, Streams::kColor).color;
        const Image covered = LoadFrame(sequence, index, Streams::kAlpha).alpha;
        for (std::size_t i = 0; i < covered.data.size(); ++i) {
          alpha.Add(covered.data[i], Brightest(color, i));
        }
      }
    } catch (const Error&) {
      continue;  // a fault of the stream itself, told there
    }
  }
  if (sequence.hud) AddFinding("hud", sequence.hud->alpha, hud, &findings);
  if (sequence.alpha) AddFinding("color", sequence.alpha->color, alpha, &findings);
  return findings;
}

}  // namespace warplut
