// The streams of a sequence: which files, and in which convention their values are stored.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace warplut {

// Streams of a frame, as a set of flags.
enum class Streams : std::uint16_t {
  kNone = 0,
  kColor = 1,
  kDepth = 2,
  kMotion = 4,
  kReference = 8,
  kReferenceDepth = 16,
  kReferenceMotion = 32,
  kReactive = 64,
  kHud = 128,
  kAlpha = 256,
  kReferenceAlpha = 512,
  kRenderGrid = kColor | kDepth | kMotion,
  kOutputGrid = kReference | kReferenceDepth | kReferenceMotion,
  kAll = kRenderGrid | kOutputGrid,  // of a scene; masks and layers are asked for by themselves
};

constexpr Streams operator|(Streams a, Streams b) {
  return static_cast<Streams>(static_cast<std::uint16_t>(a) | static_cast<std::uint16_t>(b));
}
constexpr Streams operator&(Streams a, Streams b) {
  return static_cast<Streams>(static_cast<std::uint16_t>(a) & static_cast<std::uint16_t>(b));
}
constexpr bool Contains(Streams set, Streams streams) { return (set & streams) == streams; }

// How a file's channels become one number per component.
//   kFloat         the stored value; integer files are scaled to [0, 1].
//   kRgba8Base255  v = r + g / 255 + b / 255^2 + a / 255^3 of an 8-bit RGBA file, r, g, b, a in [0,
//                  1].
enum class Encoding : std::uint8_t { kFloat, kRgba8Base255 };

// kLinear: view depth, in units where `far` is the far plane. kForward, kReversed: the depth buffer
// of a perspective projection in [0, 1], 0 at near and 1 at far, or 1 at near and 0 at far.
enum class DepthKind : std::uint8_t { kLinear, kForward, kReversed };

// Units of motion: pixels of its own grid, or the whole image = 1 (uv) or = 2 (ndc).
enum class MotionUnits : std::uint8_t { kPixels, kUv, kNdc };
// kCurrentToNext is forward flow: what is seen at the pixel moves by so much until the next frame.
enum class MotionDirection : std::uint8_t {
  kPreviousToCurrent,
  kCurrentToPrevious,
  kCurrentToNext
};
enum class YAxis : std::uint8_t { kDown, kUp };

// `path`, `path_x`, `path_y` are printf patterns (datasets/sequence/frame_pattern.h), relative to
// the manifest. `channels` names the channels to take; empty takes all that the file has.
struct ColorStream {
  std::string path;
  std::vector<std::string> channels;  // 1 or 3 names
};

// Numbers from 0 to 1.
struct MaskStream {
  std::string path;
  std::vector<std::string> channels;  // 1 name
};

// Whether the colours of a layer are stored as they are or times its alpha.
enum class AlphaKind : std::uint8_t { kStraight, kPremultiplied };

// How much of each pixel the colour covers, and how that colour is stored.
struct AlphaStream {
  std::string path;
  std::vector<std::string> channels;  // 1 name
  AlphaKind color = AlphaKind::kPremultiplied;
};

// R, G, B and alpha of what is drawn over a frame.
struct LayerStream {
  std::string path;
  std::vector<std::string> channels;  // 4 names
  AlphaKind alpha = AlphaKind::kPremultiplied;
};

struct DepthStream {
  std::string path;
  std::vector<std::string> channels;  // 1 name; 4 when packed
  Encoding encoding = Encoding::kFloat;
  double scale = 1;  // value = scale * v + bias, in the units of `kind`
  double bias = 0;
  DepthKind kind = DepthKind::kLinear;
  double near = 0;  // > 0 unless linear
  double far = 1;   // > near; infinity only when reversed
  // The stored value (after scale and bias) of what is infinitely far: it and what lies beyond it
  // is background. Without it only depth at far or at +infinity is.
  std::optional<double> background = {};
};

// Which pixels of a motion stream have no motion. A component that is NaN or infinite is invalid as
// well.
struct InvalidMotion {
  std::vector<double> values = {};  // of x or y after scale and bias, in `units`
  std::string channel = {};  // of the file: 0 or NaN where the motion is invalid; empty: none
};

struct MotionStream {
  std::string path;                   // of both components, or empty:
  std::string path_x, path_y;         // one file for each
  std::vector<std::string> channels;  // 2 names: x, y; 4 when packed (of each file)
  Encoding encoding = Encoding::kFloat;
  std::array<double, 2> scale{1, 1};  // value = scale * v + bias for x and y, in `units`
  std::array<double, 2> bias{0, 0};
  MotionUnits units = MotionUnits::kPixels;
  MotionDirection direction = MotionDirection::kPreviousToCurrent;
  YAxis y = YAxis::kDown;
  std::optional<InvalidMotion> invalid;  // without it NaN and infinity are refused
  // The motion of frame index i is in the file of index i + frame_offset: 1 where files are one
  // frame late, -1 where they are one early.
  int frame_offset = 0;
  // The motion is the difference of jittered positions: that of a still scene is the difference of
  // the jitters. It is taken out where the motion is read. Not for the output grid.
  bool contains_jitter = false;
};

}  // namespace warplut
