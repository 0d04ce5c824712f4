#include "train/calibration/clip_crop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "datasets/error.h"
#include "train/metrics/ssim.h"

namespace warplut {
namespace {

// A window of one axis, in both grids.
struct Window {
  int render_begin = 0, render_size = 0;
  int output_begin = 0, output_size = 0;
};

// The centred window of about `share` of an axis, a whole number of the least steps that both grids
// have in common.
Window CentredWindow(int render, int output, double share) {
  const int steps = std::gcd(render, output);
  const int render_step = render / steps, output_step = output / steps;
  const int kept = static_cast<int>(std::floor(steps * share + 1e-9));
  const int begin = (steps - kept) / 2;
  return {begin * render_step, kept * render_step, begin * output_step, kept * output_step};
}

ImageBuffer Crop(const ImageBuffer& image, int x, int y, int width, int height) {
  const ImageView from = image.view();
  if (from.width == 0) return {};
  ImageBuffer out(width, height, from.format);
  const std::size_t bytes = static_cast<std::size_t>(width) * BytesPerPixel(from.format);
  for (int row = 0; row < height; ++row) {
    std::memcpy(out.view().At(0, row), from.At(x, y + row), bytes);
  }
  return out;
}

MotionBuffer Crop(const MotionBuffer& motion, int x, int y, int width, int height) {
  const MotionView from = motion.view();
  if (from.width == 0) return {};
  MotionBuffer out(width, height);
  for (int row = 0; row < height; ++row) {
    std::memcpy(out.view().Row(row), from.Row(y + row) + 2 * x,
                static_cast<std::size_t>(width) * 2 * sizeof(float));
  }
  return out;
}

}  // namespace

Clip CropClip(Clip clip, int max_pixels) {
  const double pixels = static_cast<double>(clip.output.width) * clip.output.height;
  if (max_pixels == 0 || pixels <= max_pixels) return clip;
  if (!clip.render_sizes.empty()) {
    throw Error(fmt::format("the render size of '{}' varies; expected one size, to take a window",
                            clip.name));
  }
  const double share = std::sqrt(max_pixels / pixels);
  const Window x = CentredWindow(clip.render.width, clip.output.width, share);
  const Window y = CentredWindow(clip.render.height, clip.output.height, share);
  if (std::min(x.output_size, y.output_size) < kSsimWindow) {
    throw Error(
        fmt::format("'{}' ({} x {} from {} x {}) has no window of {} pixels whose borders lie "
                    "between pixels of "
                    "both grids and whose sides have {} pixels; expected more pixels",
                    clip.name, clip.output.width, clip.output.height, clip.render.width,
                    clip.render.height, max_pixels, kSsimWindow));
  }
  const auto render = [&](const auto& buffer) {
    return Crop(buffer, x.render_begin, y.render_begin, x.render_size, y.render_size);
  };
  const auto output = [&](const auto& buffer) {
    return Crop(buffer, x.output_begin, y.output_begin, x.output_size, y.output_size);
  };
  for (ClipFrame& frame : clip.frames) {
    frame.color = render(frame.color);
    frame.depth = render(frame.depth);
    frame.motion = render(frame.motion);
    frame.reactive = render(frame.reactive);
    frame.reference = output(frame.reference);
    frame.reference_depth = output(frame.reference_depth);
    frame.reference_motion = output(frame.reference_motion);
  }
  clip.render = {x.render_size, y.render_size};
  clip.output = {x.output_size, y.output_size};
  return clip;
}

}  // namespace warplut
