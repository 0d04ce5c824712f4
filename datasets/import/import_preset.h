// The conventions of the tools that frames come from.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/sequence/sequence.h"

namespace warplut {

// Which channels of a file make a stream, by the ends of their names ("Combined.R"), and which
// words in a path name it ("beauty").
struct StreamNamesOfTool {
  std::vector<std::vector<std::string>> channels;  // alternatives; each the ends of all channels
  std::vector<std::string> words;                  // lower case
};

struct ImportPreset {
  std::string_view name;
  std::string_view purpose;
  ColorSpace color_space = ColorSpace::kLinear;  // of float files; integer files are sRGB
  StreamNamesOfTool color, depth, motion;
  MotionStream motion_stream;  // paths and channels are found
  DepthStream depth_stream;
  bool two_motion_files = false;  // a file for each of x and y
  bool captures = false;          // the folder is one of captures (datasets/import/capture.h)
};

// In a fixed order. docs/IMPORT.md has the sources of each.
std::span<const ImportPreset> ImportPresets();

// An Error lists those that exist.
const ImportPreset& FindImportPreset(const std::string& name);

}  // namespace warplut
