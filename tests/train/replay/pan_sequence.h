// A small sequence on disk whose motion is known: a texture, too fine for the render grid, that
// pans at a constant speed, at constant depth.
#pragma once

#include <cmath>
#include <filesystem>

#include "datasets/jitter.h"
#include "datasets/sequence/sequence_writer.h"

namespace warplut {

struct PanOptions {
  int frames = 6;
  GridSize render = {40, 32};
  GridSize output = {80, 64};
  double speed_x = 2.5, speed_y = -1;  // output pixels per frame
  int first = 10;
  ColorSpace color_space = ColorSpace::kSrgb;
  Streams streams = Streams::kAll;
  std::vector<int> cuts = {};
  bool jitter = true;
  bool still_first_motion = false;  // the motion of the first frame is 0, as engines write it
  std::vector<GridSize> render_sizes = {};  // of each frame, where they vary
  // A white square that is elsewhere in each frame, without motion; the reactive mask covers it.
  bool spot = false;
};

class Pan {
 public:
  explicit Pan(const PanOptions& options) : options_(options) {}

  // The texture at an output position of a frame.
  float At(double x, double y, double frame, int channel) const {
    const double u = x - options_.speed_x * frame, v = y - options_.speed_y * frame;
    return static_cast<float>(0.5 + 0.2 * std::sin(1.4 * u + channel) * std::cos(0.8 * v) +
                              0.15 * std::sin(0.23 * u - 0.31 * v));
  }

  Frame At(int index, Vec2 jitter) const {
    Frame frame;
    const auto [rw, rh] = options_.render_sizes.empty()
                              ? options_.render
                              : options_.render_sizes[static_cast<std::size_t>(index)];
    const auto [ow, oh] = options_.output;
    const double sx = static_cast<double>(ow) / rw, sy = static_cast<double>(oh) / rh;
    const bool still = index == 0 && options_.still_first_motion;
    const double speed_x = still ? 0 : options_.speed_x, speed_y = still ? 0 : options_.speed_y;
    frame.color = Color(rw, rh, sx, sy, jitter, index);
    frame.depth = Constant(rw, rh, {0.5f});
    frame.motion =
        Constant(rw, rh, {static_cast<float>(speed_x / sx), static_cast<float>(speed_y / sy)});
    frame.reference = Color(ow, oh, 1, 1, {}, index);
    frame.reference_depth = Constant(ow, oh, {0.5f});
    frame.reference_motion =
        Constant(ow, oh, {static_cast<float>(speed_x), static_cast<float>(speed_y)});
    frame.reactive = Image(rw, rh, 1);
    for (int y = 0; y < rh; ++y) {
      for (int x = 0; x < rw; ++x) {
        const bool spot = IsSpot((x + 0.5 + jitter.x) * sx, (y + 0.5 + jitter.y) * sy, index);
        frame.reactive.at(x, y) = spot ? 1.0f : 0.0f;
      }
    }
    frame.hud = Hud(ow, oh);
    return frame;
  }

 private:
  bool IsSpot(double x, double y, int index) const {
    const double left = 12 + 17 * index % 40, top = 20 + 11 * index % 24;
    return options_.spot && x >= left && x < left + 12 && y >= top && y < top + 12;
  }

  // White stripes of one pixel on a bar that is half transparent; premultiplied.
  static Image Hud(int width, int height) {
    Image hud(width, height, 4);
    for (int y = height / 2; y < height / 2 + 8; ++y) {
      for (int x = width / 4; x < width / 2; ++x) {
        const bool stripe = x % 3 == 0;
        for (int c = 0; c < 4; ++c) hud.at(x, y, c) = stripe ? 1.0f : c == 3 ? 0.5f : 0.0f;
      }
    }
    return hud;
  }

  Image Color(int width, int height, double sx, double sy, Vec2 jitter, int index) const {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        for (int c = 0; c < 3; ++c) {
          const double u = (x + 0.5 + jitter.x) * sx, v = (y + 0.5 + jitter.y) * sy;
          image.at(x, y, c) = IsSpot(u, v, index) ? 1.0f : At(u, v, index, c);
        }
      }
    }
    return image;
  }

  static Image Constant(int width, int height, const std::vector<float>& values) {
    Image image(width, height, static_cast<int>(values.size()));
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = values[i % values.size()];
    return image;
  }

  PanOptions options_;
};

// Writes it into `folder` and returns what is read back.
inline Sequence WritePan(const std::filesystem::path& folder, const PanOptions& options = {}) {
  Sequence sequence =
      StandardSequence("pan", options.first, options.frames, options.render, options.output,
                       options.color_space, options.streams, 0.1, 100);
  if (options.jitter) {
    sequence.jitter = JitterCycle(static_cast<double>(options.output.width) / options.render.width);
  }
  sequence.cuts = options.cuts;
  sequence.render_sizes = options.render_sizes;
  const SequenceWriter writer(folder, sequence);
  const Pan pan(options);
  for (int i = 0; i < options.frames; ++i) {
    writer.Write(i,
                 pan.At(i, options.jitter ? sequence.jitter[static_cast<std::size_t>(i)] : Vec2{}));
  }
  writer.Finish();
  return ReadSequence(folder);
}

}  // namespace warplut
