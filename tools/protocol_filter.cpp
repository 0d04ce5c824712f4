#include "tools/protocol_filter.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <vector>

#include "datasets/error.h"

namespace warplut {
namespace {

constexpr std::string_view kKeysPrefix = "keys:";

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
  return UniformFilter(
      name, [options](const ImageView& history, const MotionView& motion,
                      const MutableImageView& out) { Warp(history, motion, options, out); });
}

std::optional<WarpOptions> NamedWarp(const std::string& name) {
  for (const FilterInfo& info : kFilters) {
    if (!info.needs_a && !info.needs_table && name == info.name) {
      return WarpOptions{.filter = info.filter};
    }
  }
  if (name.starts_with(kKeysPrefix)) {
    const std::string_view text = std::string_view(name).substr(kKeysPrefix.size());
    WarpOptions options{.filter = Filter::kKeys};
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), options.keys_a);
    if (error == std::errc() && end == text.data() + text.size() && options.IsValid(nullptr)) {
      return options;
    }
  }
  return std::nullopt;
}

ProtocolFilter NamedFilter(const std::string& name) {
  if (const auto options = NamedWarp(name)) return RuntimeFilter(name, *options);
  throw Error(
      fmt::format("'{}' is not a filter; expected bilinear, catmull-rom, best-keys or keys:A with "
                  "A in [-1, 0].",
                  name));
}

std::string KeysName(double a) { return fmt::format("{}{:.4f}", kKeysPrefix, a); }

}  // namespace warplut
