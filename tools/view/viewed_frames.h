// Frames of two sources, moment by moment, and the ideal frames where there are some.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/judge/images/compare.h"

namespace warplut {

// One moment; R, G, B in [0, 1] as displayed.
struct ViewedFrame {
  std::string name;
  Image a, b;
  Image reference;  // empty: there is none

  bool HasReference() const { return !reference.empty(); }
};

// The files of all moments.
struct ViewedFrames {
  struct Files {
    std::string name;  // without an extension
    ListedImage a, b;
    std::optional<ListedImage> reference;
  };
  std::string a, b;  // names of the sources, which differ
  JudgedDomain domain = JudgedDomain::kStored;
  std::vector<Files> files;  // at least one

  bool HasReference() const { return files.front().reference.has_value(); }
  // An Error if two images of the moment have different sizes, or as LoadCompared.
  ViewedFrame Load(std::size_t index) const;
};

// The images of two paths, paired by file name, with those of `reference` (empty: none). Errors as
// PairFrames.
ViewedFrames FramesOfFolders(const std::string& a, const std::string& b,
                             const std::string& reference, bool linear);

}  // namespace warplut
