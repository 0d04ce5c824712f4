// Captures of Arm's neural graphics tools: many sequences in one folder, at several upscale
// factors, each with a JSON file of what its frames do not tell.
//
//   CAPTURE.json
//   ground_truth/CAPTURE/0000.exr, motion_gt/CAPTURE/0000.exr
//   xRATIO/color/CAPTURE/0000.exr, xRATIO/depth/..., xRATIO/motion/...     RATIO as 2 or 1_5
//
// Source: the NSS Dataset Specification of Arm's neural graphics model gym (version 1.0.1) and the
// exporter of its capture plugin for Unreal.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "datasets/frame.h"
#include "datasets/import/numbered_files.h"

namespace warplut {

// One capture at one ratio.
struct Capture {
  std::string name;
  std::string ratio;  // the folder, "x2"
};

// The files of one capture at one ratio, and of its references. `name` empty: the only capture;
// `scale` 1: the only ratio. An Error lists those that there are where there is none or several.
Capture FindCapture(const std::vector<NumberedFiles>& files, const std::string& name, double scale);

// Whether the pattern is of the capture: its input, its reference or the reference's motion.
bool IsOfCapture(const Capture& capture, const std::string& pattern);

struct CaptureMetadata {
  std::map<int, Vec2> jitter;  // by the number of the frame: render pixels, y down
  std::vector<int> cuts;       // numbers of frames, ascending
  bool reversed_depth = false;
  double near = 0;
  double far = 0;  // infinity where the file has -1
};

// An Error names the file and the field that is missing or makes no sense.
CaptureMetadata ReadCaptureMetadata(const std::filesystem::path& path);

}  // namespace warplut
