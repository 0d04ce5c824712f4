// Frames as another tool wrote them, made into a sequence.
#pragma once

#include <array>
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
  // JSON with fields as in a manifest that frames do not tell (kImportFields); empty: none.
  std::filesystem::path fields;
  std::string reactive, hud;  // patterns of these streams in the folder; empty: none
  std::string capture;        // of the preset arm; empty: the only one
  bool alpha = false;         // that of the colour's files, and of the references'
  bool replace = false;       // a manifest that is there
};

// Fields of a manifest that `fields` of a request may have.
inline constexpr std::array kImportFields = {"jitter", "camera", "cuts", "exposures"};

struct ImportResult {
  std::filesystem::path manifest;
  Sequence sequence;
  std::vector<std::string> notes;  // one sentence each: what was found, what was not
};

// Finds the numbered files in the folder, takes those that the preset's words and channels name,
// writes the manifest and reads it back. Files in folders named hr, HR_Inputs, reference, ref or gt
// are references. Frames are those that colour has; where numbers have a gap the frame after it is
// a cut. Where the sizes of colour differ they are `render_sizes`. The alpha of a HUD and of colour
// is premultiplied in OpenEXR and straight in other formats. Depth in .dpt is converted to OpenEXR,
// in depth_exr/. Every pixel of depth is read where `far` is not given; depth that is reversed
// needs `near`, and without `far` it is infinite. The manifest of a capture that is named is
// sequence-CAPTURE.json. An Error says what is missing, and what was found.
ImportResult ImportSequence(const ImportRequest& request);

}  // namespace warplut
