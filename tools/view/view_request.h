// What a person asks to see.
#pragma once

#include <string>
#include <vector>

#include "tools/device.h"
#include "tools/pipeline.h"

namespace warplut {

struct ViewRequest {
  std::vector<std::string> folders;                       // of images, or image files: two, or none
  std::string reference;                                  // of the folders; empty: none
  std::string sequence;                                   // empty: the folders
  std::vector<std::string> methods = {"sr", "bilinear"};  // two, on the sequence
  PipelineArguments pipeline;
  int every = 2;  // for methods that generate
  std::string device = DeviceNames().front();
  bool linear = false;  // folders hold linear HDR
  std::string out;
  int shown = 4;       // frames on the sheet and the page, beside the worst ones
  double amplify = 4;  // differences in pictures of the error are so many times larger
  double rate = 10;    // frames of the video per second

  // Whether it makes sense; otherwise *why says what does not. No file is opened.
  bool IsValid(std::string* why) const;
};

inline constexpr int kMostShown = 64;
inline constexpr double kMostAmplify = 256;
inline constexpr double kMostRate = 240;

}  // namespace warplut
