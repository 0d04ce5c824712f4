// A sequence on disk: its manifest, sequence.json version 1 or 2, and its frames.
// docs/FORMATS.md is the users' page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/frame.h"
#include "datasets/sequence/stream.h"

namespace warplut {

struct GridSize {
  int width = 0;
  int height = 0;
  bool operator==(const GridSize&) const = default;
};

enum class ColorSpace : std::uint8_t { kSrgb, kLinear };

// The manifest, as plain values. color, depth and motion are on the render grid, reference* on the
// output grid.
struct Sequence {
  static constexpr int kVersion = 1;        // the least that a manifest is written in
  static constexpr int kLatestVersion = 2;  // fields that version 1 lacks: UsesVersion2
  static constexpr const char* kFormat = "warplut-sequence";
  static constexpr const char* kManifest = "sequence.json";
  static constexpr double kMinScale = 1, kMaxScale = 4;  // output / render, in each axis
  static constexpr int kMaxFrames = 1'000'000;
  static constexpr double kMaxJitter = 1;          // render pixels, in each axis
  static constexpr double kMaxExposure = 1 << 20;  // and its inverse is the least

  std::filesystem::path folder;  // what the streams' paths are relative to; not stored
  int levels_up = 0;             // how many ".." they may begin with; not stored
  std::string name;              // not empty, no '/' and no control characters
  int first = 0;                 // number of frame index 0
  int count = 0;
  std::vector<int> numbers;  // of each frame, ascending, from `first`; empty: without gaps
  GridSize render;
  GridSize output;
  // Of each frame where they vary (dynamic resolution), at most `render`; empty: all are `render`.
  std::vector<GridSize> render_sizes;
  ColorSpace color_space = ColorSpace::kSrgb;
  // Of each frame, of linear colour: what the light was multiplied by in the files of its colour
  // and its reference. Empty: by the same.
  std::vector<double> exposures;

  ColorStream color;
  std::optional<DepthStream> depth;
  std::optional<MotionStream> motion;
  std::optional<ColorStream> reference;
  std::optional<DepthStream> reference_depth;
  std::optional<MotionStream> reference_motion;
  std::optional<MaskStream> reactive;  // render grid
  std::optional<LayerStream> hud;      // output grid
  std::optional<AlphaStream> alpha;    // of color
  std::optional<AlphaStream> reference_alpha;

  std::vector<Vec2> jitter;    // of frame index i: [i % size], render pixels, y down; empty: none
  std::vector<Camera> camera;  // one for each frame, or empty
  std::vector<int> cuts;       // frame numbers, ascending, each once

  // The number of the frame at `index`, as in its files' names, and that of the last frame.
  int Number(int index) const {
    return numbers.empty() ? first + index : numbers[static_cast<std::size_t>(index)];
  }
  int LastNumber() const { return Number(count - 1); }
  GridSize RenderSize(int index) const {
    return render_sizes.empty() ? render : render_sizes[static_cast<std::size_t>(index)];
  }

  // Relative to the first frame.
  double Exposure(int index) const {
    return exposures.empty() ? 1 : exposures[static_cast<std::size_t>(index)] / exposures.front();
  }

  // Whether a field is used that version 1 of the manifest lacks.
  bool UsesVersion2() const;

  // Whether every value is in its range; if not and `why` is given, *why names the field, what it
  // is and what was expected.
  bool IsValid(std::string* why = nullptr) const;
};

// The streams that the manifest names, and their names in it ("color", "depth", ...).
Streams AvailableStreams(const Sequence& sequence);
std::vector<std::string> StreamNames(Streams streams);

// The files of these streams of the frame at `index` (0 to count - 1): absolute or relative as
// `folder` is. Streams that the manifest does not name have none.
std::vector<std::filesystem::path> FrameFiles(const Sequence& sequence, int index, Streams which);

// Reads `path`, a manifest or the folder of a sequence.json, and checks all of it. The files of the
// streams are not opened. An Error names the manifest, the field, what was found and what was
// expected; unknown and repeated fields are refused. Streams lie below the manifest's folder, or,
// if `streams_below` is given, below that folder, in which the manifest must lie.
Sequence ReadSequence(const std::filesystem::path& path,
                      const std::filesystem::path& streams_below = {});

// The folders right below `folder` that have a sequence.json, in ascending order of their names as
// bytes.
std::vector<std::filesystem::path> SequencesBelow(const std::filesystem::path& folder);

// The manifest as text: what ReadSequence reads back to the same values. A pure function. Error if
// not valid.
std::string SequenceJson(const Sequence& sequence);

// Forward flow becomes motion of the frame that it leads to (datasets/sequence/forward_flow.h).
// Motion that is missing is that of the camera, where the sequence has cameras and depth (datasets/
// camera_fill.h); elsewhere it is (0, 0). Frames whose motion lies in no file have none.
//
// Reads the streams `which` of the frame at `index` (0 to count - 1), converted to the convention
// of datasets/frame.h as datasets/encoding.h describes; only their files are opened. Grey colour is
// copied to R, G and B; a fourth channel is dropped. Straight colour is multiplied by its alpha
// where the alpha is read too. Colours are brought to the exposure of the first frame. Number, cut,
// jitter and camera are always set. Frame 0 is a cut only where the manifest says so; what runs
// over frames takes it as one (train/replay/clip.h).
//
// Error, naming the file or the stream and the sequence: index out of range, a stream that the
// manifest lacks, a missing or damaged file, a file of another size or with other channels, a NaN,
// an infinite value (but in depth, where +infinity is background, and in linear colour, which is
// left as it is: LoadClip limits it), a negative depth, a mask or an alpha outside [0, 1], and a
// colour outside [0, 1] unless the sequence is linear. Threads may load frames of one sequence at
// the same time.
Frame LoadFrame(const Sequence& sequence, int index, Streams which);

}  // namespace warplut
