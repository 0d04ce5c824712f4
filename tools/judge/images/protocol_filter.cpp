#include "tools/judge/images/protocol_filter.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "datasets/error.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/prefilter.h"
#include "tools/judge/images/filter_family.h"
#include "tools/judge/images/plain_warp.h"
#include "tools/judge/images/six_taps.h"

namespace warplut {
namespace {

constexpr std::string_view kKeysPrefix = "keys:";
constexpr std::string_view kSplinePrefix = "spline:";
constexpr std::string_view kKaiserPrefix = "kaiser6:";
constexpr std::string_view kOMoms = "o-moms";
constexpr std::string_view kLanczos = "lanczos3";

std::optional<double> Decimal(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

// The number after the prefix, a decimal one or a fraction.
std::optional<float> NumberAfter(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  const std::string_view text = name.substr(prefix.size());
  const auto slash = text.find('/');
  const auto numerator = Decimal(text.substr(0, slash));
  const auto denominator = slash == text.npos ? 1.0 : Decimal(text.substr(slash + 1));
  if (!numerator || !denominator || *denominator == 0) return std::nullopt;
  return static_cast<float>(*numerator / *denominator);
}

// The warp through the coefficients that the prefilter makes of the history.
void PrefilteredWarp(const WarpOptions& options, const ImageView& history, const MotionView& motion,
                     const MutableImageView& out) {
  SerialExecutor executor;
  ImageBuffer coefficients(history.width, history.height, CoefficientFormat(history.format));
  PrefilterPass(PrefilterOf(options), history.width, history.height, executor.Threads())
      .Apply(history, executor, coefficients.view());
  Warp(PrefilteredImage{.samples = history, .coefficients = coefficients}, motion, options, out);
}

// Six by six weights; those of the pixel before are taken again where the offset is the same.
class SixTapSampler {
 public:
  explicit SixTapSampler(const std::function<SixTaps(float)>& taps) : taps_(taps) {}

  PlainTexel operator()(const PlainHistory& history, int x, int y, float dx, float dy) {
    if (!known_ || dx != dx_ || dy != dy_) {
      wx_ = taps_(dx);
      wy_ = taps_(dy);
      dx_ = dx;
      dy_ = dy;
      known_ = true;
    }
    return Sum36(history, x, y, wx_, wy_);
  }

 private:
  std::function<SixTaps(float)> taps_;
  bool known_ = false;
  float dx_ = 0, dy_ = 0;
  SixTaps wx_{}, wy_{};
};

ProtocolFilter SixTapFilter(const std::string& name, const std::function<SixTaps(float)>& taps) {
  return UniformFilter(name, [taps](const ImageView& history, const MotionView& motion,
                                    const MutableImageView& out) {
    PlainWarp(history, motion, SixTapSampler(taps), out);
  });
}

void WarpUniformly(const MotionWarp& warp, const Image& in, const Displacement& v, Image& out) {
  std::vector<float> motion(in.pixels() * 2);
  for (std::size_t pixel = 0; pixel < in.pixels(); ++pixel) {
    motion[2 * pixel] = static_cast<float>(v.x);
    motion[2 * pixel + 1] = static_cast<float>(v.y);
  }
  const std::ptrdiff_t stride = std::ptrdiff_t{in.width} * BytesPerPixel(PixelFormat::kR32F);
  const ImageView history = {.data = in.data.data(),
                             .width = in.width,
                             .height = in.height,
                             .stride = stride,
                             .format = PixelFormat::kR32F};
  const MutableImageView result = {.data = out.data.data(),
                                   .width = out.width,
                                   .height = out.height,
                                   .stride = stride,
                                   .format = PixelFormat::kR32F};
  const MotionView field = {
      .xy = motion.data(), .width = in.width, .height = in.height, .stride = 2 * stride};
  warp(history, field, result);
}

}  // namespace

ProtocolFilter UniformFilter(const std::string& name, const MotionWarp& warp) {
  return {.name = name, .warp = [warp](const Image& in, const Displacement& v, Image& out) {
            WarpUniformly(warp, in, v, out);
          }};
}

ProtocolFilter RuntimeFilter(const std::string& name, const WarpOptions& options) {
  const bool prefiltered = HasPrefilter(PrefilterOf(options));
  return UniformFilter(name,
                       [options, prefiltered](const ImageView& history, const MotionView& motion,
                                              const MutableImageView& out) {
                         if (prefiltered) {
                           PrefilteredWarp(options, history, motion, out);
                         } else {
                           Warp(history, motion, options, out);
                         }
                       });
}

std::optional<WarpOptions> NamedWarp(const std::string& name) {
  for (const FilterInfo& info : kFilters) {
    if (!info.needs_a && !info.needs_k && !info.needs_table && name == info.name) {
      return WarpOptions{.filter = info.filter};
    }
  }
  std::optional<WarpOptions> options;
  if (name == kOMoms) {
    options = {.filter = Filter::kSpline, .spline_k = static_cast<float>(kOMomsK)};
  } else if (const auto a = NumberAfter(kKeysPrefix, name)) {
    options = {.filter = Filter::kKeys, .keys_a = *a};
  } else if (const auto k = NumberAfter(kSplinePrefix, name)) {
    options = {.filter = Filter::kSpline, .spline_k = *k};
  }
  return options && options->IsValid(nullptr) ? options : std::nullopt;
}

std::string WarpNames() {
  return fmt::format(
      "bilinear, catmull-rom, {}A with A in [-1, 0], {}K with K in [{}, {}] or {} (K = 1/42)",
      kKeysPrefix, kSplinePrefix, kLeastSplineK, kLargestSplineK, kOMoms);
}

ProtocolFilter NamedFilter(const std::string& name) {
  if (const auto options = NamedWarp(name)) return RuntimeFilter(name, *options);
  if (name == kLanczos) return SixTapFilter(name, LanczosTaps);
  const auto b = NumberAfter(kKaiserPrefix, name);
  if (b && *b >= 0 && *b <= static_cast<float>(kLargestKaiser)) {
    return SixTapFilter(name, [b = *b](float d) { return KaiserSixTaps(b, d); });
  }
  throw Error(fmt::format("'{}' is not a filter; expected {}, {}, {}B with B in [0, {}], {} or {}.",
                          name, kBestKeys, kBestSpline, kKaiserPrefix, kLargestKaiser, kLanczos,
                          WarpNames()));
}

std::string KeysName(double a) { return fmt::format("{}{:.4f}", kKeysPrefix, a); }

std::string SplineName(double k) { return fmt::format("{}{:.4f}", kSplinePrefix, k); }

}  // namespace warplut
