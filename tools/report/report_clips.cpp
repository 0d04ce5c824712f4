#include "tools/report/report_clips.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "datasets/error.h"
#include "datasets/scenes/scene_renderer.h"
#include "tools/scene_rendering.h"
#include "train/calibration/clip_crop.h"

namespace warplut {
namespace {

// A static camera, disocclusion, and changing light.
constexpr std::array<std::string_view, 3> kQuickScenes = {"courtyard", "plaza", "colonnade"};
constexpr std::array<std::string_view, 2> kLargerScenes = {"street", "colonnade"};
constexpr std::array<std::string_view, 1> kQuickLargerScenes = {"colonnade"};

constexpr double kScale = 2;

// What methods that generate need for one frame to be judged.
constexpr int kFewestFrames = 3;
// Output pixels of a person's clips.
constexpr int kClipPixels = 640 * 360, kQuickClipPixels = 320 * 180;

std::vector<std::string> Names(const ReportScenes& scenes) {
  if (scenes.scenes.empty()) return SelectScenes("all");
  return {scenes.scenes.begin(), scenes.scenes.end()};
}

ReportClip LoadSequenceClip(const Sequence& sequence, int frames) {
  ReportClip clip;
  clip.name = sequence.name;
  clip.sequence = sequence;
  const Streams which = AvailableStreams(sequence);
  clip.dense = LoadClip(sequence, 0, frames, which, 1, MotionFiltering::kQuantised);
  clip.sparse = LoadClip(sequence, 0, frames, which, kReportEvery, MotionFiltering::kQuantised);
  return clip;
}

}  // namespace

ReportScenes OrdinaryScenes(bool quick) {
  if (quick) {
    return {.width = 320, .height = 180, .frames = 9, .samples = 8, .scenes = kQuickScenes};
  }
  return {.width = 480, .height = 270, .frames = 13, .samples = 12, .scenes = {}};
}

ReportScenes LargerScenes(bool quick) {
  if (quick) {
    return {.width = 640, .height = 360, .frames = 5, .samples = 4, .scenes = kQuickLargerScenes};
  }
  return {.width = 960, .height = 540, .frames = 7, .samples = 8, .scenes = kLargerScenes};
}

int CountFrames(const ReportScenes& scenes) {
  return static_cast<int>(Names(scenes).size()) * scenes.frames;
}

std::vector<ReportClip> RenderReportClips(const ReportScenes& scenes, std::uint64_t seed,
                                          int threads, const std::filesystem::path& folder,
                                          const std::function<void(const std::string&)>& on_frame) {
  const RenderOptions options{.width = scenes.width,
                              .height = scenes.height,
                              .scale = kScale,
                              .frames = scenes.frames,
                              .samples = scenes.samples,
                              .seed = seed,
                              .threads = threads};
  std::vector<ReportClip> clips;
  for (const std::string& name : Names(scenes)) {
    // What was rendered with other options is not gone on with.
    const std::filesystem::path path =
        folder /
        fmt::format("{}x{}-{}-frames-{}-samples-seed-{}", scenes.width, scenes.height,
                    scenes.frames, scenes.samples, seed) /
        name;
    int left = scenes.frames;
    RenderScene(name, options, Streams::kAll, path, [&] {
      if (left-- > 0) on_frame(name);
    });
    clips.push_back(LoadSequenceClip(ReadSequence(path), scenes.frames));
    clips.back().built_in = true;
  }
  return clips;
}

void AddSequence(const std::filesystem::path& path, const std::filesystem::path& streams_below,
                 bool quick, std::vector<ReportClip>* clips, std::vector<ReportClip>* larger) {
  const Sequence sequence = ReadSequence(path, streams_below);
  const Streams available = AvailableStreams(sequence);
  for (const Streams one : {Streams::kColor, Streams::kDepth, Streams::kMotion, Streams::kReference,
                            Streams::kReferenceDepth, Streams::kReferenceMotion}) {
    if (Contains(available, one)) continue;
    throw Error(fmt::format("the sequence '{}' has no {}; a report judges by references",
                            sequence.name, StreamNames(one).front()));
  }
  if (sequence.count < kFewestFrames) {
    throw Error(fmt::format("the sequence '{}' has {} frames; a report needs at least {}",
                            sequence.name, sequence.count, kFewestFrames));
  }
  for (const ReportClip& clip : *clips) {
    if (clip.name == sequence.name) {
      throw Error(fmt::format("two sequences have the name '{}'", sequence.name));
    }
  }
  const ReportScenes ordinary = OrdinaryScenes(quick), large = LargerScenes(quick);
  const int pixels = quick ? kQuickClipPixels : kClipPixels;
  ReportClip clip = LoadSequenceClip(sequence, std::min(sequence.count, ordinary.frames));
  if (clip.dense.output.width * clip.dense.output.height > pixels) {
    larger->push_back(LoadSequenceClip(sequence, std::min(sequence.count, large.frames)));
    clip.dense = CropClip(std::move(clip.dense), pixels);
    clip.sparse = CropClip(std::move(clip.sparse), pixels);
  }
  clips->push_back(std::move(clip));
}

Clip ReloadClip(const ReportClip& clip, Streams which, int most_frames) {
  const int frames = std::min(static_cast<int>(clip.dense.frames.size()), most_frames);
  Clip loaded = LoadClip(clip.sequence, 0, frames, which, 1, MotionFiltering::kQuantised);
  const GridSize wanted = clip.dense.output;
  if (loaded.output == wanted) return loaded;
  return CropClip(std::move(loaded), wanted.width * wanted.height);
}

}  // namespace warplut
