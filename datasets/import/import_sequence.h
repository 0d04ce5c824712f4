// Frames as another tool wrote them, made into a sequence.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/import/import_preset.h"

namespace warplut {

struct ImportRequest {
  std::filesystem::path folder;  // of the frames; the manifest goes here
  std::string preset;
  std::string name;                 // empty: that of the folder
  double scale = 1;                 // output / render, where there are no references
  std::optional<double> near, far;  // of the depth; far not given: the largest depth that is found
  std::filesystem::path cameras;    // JSON with `camera` and `jitter` as in a manifest; empty: none
  bool replace = false;             // a manifest that is there
};

struct ImportResult {
  Sequence sequence;
  std::vector<std::string> notes;  // one sentence each: what was found, what was not
};

// Finds the numbered files in the folder, takes those that the preset's words and channels name,
// writes the manifest and reads it back. Files in folders named hr, HR_Inputs, reference, ref or gt
// are references. Frames are those that colour has; where numbers have a gap the frame after it is
// a cut. Depth in .dpt is converted to OpenEXR, in depth_exr/. Every pixel of depth is read where
// `far` is not given. An Error says what is missing, and what was found.
ImportResult ImportSequence(const ImportRequest& request);

}  // namespace warplut
