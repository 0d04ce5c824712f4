// The sequences that a report is made with.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/report/report_inputs.h"

namespace warplut {

// Built-in scenes as they are rendered for a report: a size and some scenes.
struct ReportScenes {
  int width = 0, height = 0;  // of the output grid; the render grid is half of it
  int frames = 0;
  int samples = 0;
  std::span<const std::string_view> scenes;  // empty: all
};

// What everything is judged on, and the second resolution.
ReportScenes OrdinaryScenes(bool quick);
ReportScenes LargerScenes(bool quick);

// Renders into FOLDER/WIDTHxHEIGHT/SCENE, or goes on with what is there, and loads. `on_frame` is
// called before each frame of each scene with the scene's name; what it throws ends the work.
std::vector<ReportClip> RenderReportClips(const ReportScenes& scenes, std::uint64_t seed,
                                          int threads, const std::filesystem::path& folder,
                                          const std::function<void(const std::string&)>& on_frame);
int CountFrames(const ReportScenes& scenes);

// Reads a person's sequence. `clips` gets its first frames, where they have many pixels a window
// from the middle of them; then `larger` gets fewer frames, whole. An Error names the sequence if
// it lacks a stream, has fewer than 3 frames or a name that one of the clips has; or as
// ReadSequence, LoadClip and CropClip.
void AddSequence(const std::filesystem::path& path, const std::filesystem::path& streams_below,
                 bool quick, std::vector<ReportClip>* clips, std::vector<ReportClip>* larger);

// The same part of the sequence again, from its files: the streams `which` of its first frames, at
// most those of the clip.
Clip ReloadClip(const ReportClip& clip, Streams which, int most_frames);

}  // namespace warplut
