#include "tests/stability/cases/stability_clip.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "luts/baked/warplut_sr_x2.h"
#include "luts/baked/warplut_x2.h"
#include "runtime/core/pixel.h"

namespace warplut {
namespace {

// Calls pixel(x, y, texel) for every pixel of a grid on which the render grid has `scale` pixels
// each.
template <class Pixel>
void ForEachTexel(const ClipContent& content, int number, int width, int height, double scale_x,
                  double scale_y, Vec2 jitter, const Pixel& pixel) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      pixel(x, y, content((x + 0.5) / scale_x + jitter.x, (y + 0.5) / scale_y + jitter.y, number));
    }
  }
}

void SetPixel(const ClipTexel& texel, float scale_x, float scale_y, int x, int y,
              const MutableImageView& color, const MutableImageView& depth,
              const MutableMotionView& motion) {
  float* pixel = color.Row<float>(y) + 4 * x;
  std::copy(std::begin(texel.color), std::end(texel.color), pixel);
  pixel[3] = 1;
  depth.Row<float>(y)[x] = texel.depth;
  motion.Row(y)[2 * x] = static_cast<float>(texel.motion_x) * scale_x;
  motion.Row(y)[2 * x + 1] = static_cast<float>(texel.motion_y) * scale_y;
}

double ChannelValue(const ImageView& image, int x, int y, int c) {
  const double value = LoadChannel(image.format, image.At(x, y), c);
  return image.format == PixelFormat::kRgba8 ? value / 255 : value;
}

double PixelDifference(const ImageView& a, const ImageView& b, int x, int y) {
  double most = 0;
  for (int c = 0; c < Channels(a.format); ++c) {
    const double difference = std::abs(ChannelValue(a, x, y, c) - ChannelValue(b, x, y, c));
    if (!(difference <= std::numeric_limits<double>::max())) {
      return std::numeric_limits<double>::infinity();
    }
    most = std::max(most, difference);
  }
  return most;
}

}  // namespace

ClipFrame MakeClipFrame(GridSize render, GridSize output) {
  constexpr PixelFormat kColor = PixelFormat::kRgba32F;
  ClipFrame frame;
  frame.color = ImageBuffer(render.width, render.height, kColor);
  frame.depth = ImageBuffer(render.width, render.height, PixelFormat::kR32F);
  frame.motion = MotionBuffer(render.width, render.height);
  if (output.width > 0) {
    frame.reference = ImageBuffer(output.width, output.height, kColor);
    frame.reference_depth = ImageBuffer(output.width, output.height, PixelFormat::kR32F);
    frame.reference_motion = MotionBuffer(output.width, output.height);
  }
  return frame;
}

void RenderClipFrame(const ClipContent& content, int number, Vec2 jitter, ClipFrame& frame) {
  frame.number = number;
  frame.jitter = jitter;
  const MutableImageView color = frame.color.view();
  const MutableImageView depth = frame.depth.view();
  const MutableMotionView motion = frame.motion.view();
  ForEachTexel(content, number, color.width, color.height, 1, 1, jitter,
               [&](int x, int y, const ClipTexel& texel) {
                 SetPixel(texel, 1, 1, x, y, color, depth, motion);
               });
  const MutableImageView reference = frame.reference.view();
  if (reference.width == 0) return;
  const MutableImageView reference_depth = frame.reference_depth.view();
  const MutableMotionView reference_motion = frame.reference_motion.view();
  const double scale_x = static_cast<double>(reference.width) / color.width;
  const double scale_y = static_cast<double>(reference.height) / color.height;
  ForEachTexel(content, number, reference.width, reference.height, scale_x, scale_y, {},
               [&](int x, int y, const ClipTexel& texel) {
                 SetPixel(texel, static_cast<float>(scale_x), static_cast<float>(scale_y), x, y,
                          reference, reference_depth, reference_motion);
               });
}

Clip MakeClip(GridSize render, GridSize output, int frames, const ClipContent& content) {
  Clip clip;
  clip.name = "formula";
  clip.render = render;
  clip.output = output;
  for (int i = 0; i < frames; ++i) {
    clip.frames.push_back(MakeClipFrame(render, output));
    RenderClipFrame(content, i, QuarterJitter(i), clip.frames.back());
  }
  return clip;
}

Vec2 QuarterJitter(int number) {
  constexpr double kX[4] = {-0.25, 0.25, 0.25, -0.25};
  constexpr double kY[4] = {-0.25, 0.25, -0.25, 0.25};
  return {kX[number % 4], kY[number % 4]};
}

void Texture(double x, double y, double period, float color[3]) {
  const double u = 2 * std::numbers::pi * x / period;
  const double v = 2 * std::numbers::pi * y / period;
  color[0] = static_cast<float>(0.5 + 0.2 * std::sin(3 * u + v) + 0.2 * std::cos(5 * v));
  color[1] = static_cast<float>(0.5 + 0.25 * std::sin(4 * v - 2 * u) + 0.15 * std::cos(7 * u));
  color[2] = static_cast<float>(0.5 + 0.4 * std::sin(u) * std::cos(2 * v));
}

float Noise(int x, int y, int frame) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^
                    static_cast<std::uint32_t>(y) * 0x85EBCA77u ^
                    static_cast<std::uint32_t>(frame) * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  h ^= h >> 15;
  return static_cast<float>(h >> 8) * 0x1p-24f;
}

const TableView& StoredHistoryTable() { return baked::kWarplutSrX2; }

const TableView& StoredWarpTable() { return baked::kWarplutX2; }

const Table& HistoryTable() {
  static const Table table(StoredHistoryTable());
  return table;
}

const Table& WarpTable() {
  static const Table table(StoredWarpTable());
  return table;
}

WarpOptions HistoryWarp(Lookup lookup) {
  return {.filter = Filter::kLut, .table = &HistoryTable(), .lookup = lookup};
}

bool SameBits(const ImageView& a, const ImageView& b) {
  const auto bytes = static_cast<std::size_t>(a.width) * BytesPerPixel(a.format);
  for (int y = 0; y < a.height; ++y) {
    if (std::memcmp(a.At(0, y), b.At(0, y), bytes) != 0) return false;
  }
  return true;
}

double LargestDifference(const ImageView& a, const ImageView& b) {
  double most = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) most = std::max(most, PixelDifference(a, b, x, y));
  }
  return most;
}

double DifferingShare(const ImageView& a, const ImageView& b, double bound) {
  std::int64_t differing = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) differing += PixelDifference(a, b, x, y) > bound ? 1 : 0;
  }
  return static_cast<double>(differing) / (static_cast<double>(a.width) * a.height);
}

ValueRange RangeOf(const ImageView& image) {
  ValueRange range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value = ChannelValue(image, x, y, c);
        if (std::isnan(value)) return {1, 0};
        range.least = std::min(range.least, value);
        range.largest = std::max(range.largest, value);
      }
    }
  }
  return range;
}

double WarpBound(PixelFormat format) {
  switch (format) {
    case PixelFormat::kRgba8:
      return kWarpRgba8Bound / 255.0;
    case PixelFormat::kRgba16F:
      return static_cast<double>(kWarpFloatBound) + 0x1p-11;
    case PixelFormat::kRgba32F:
    case PixelFormat::kR32F:
      break;
  }
  return static_cast<double>(kWarpFloatBound);
}

}  // namespace warplut
