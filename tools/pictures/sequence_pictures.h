// Where methods differ from the reference, side by side for the eye.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/pictures/picture_window.h"
#include "train/replay/mode_run.h"

namespace warplut {

inline constexpr int kWindowsOfAKind = 2;  // by error, and by disocclusion

// Finds the windows of the frames that one method is judged by where its squared error is largest,
// and those where most was just revealed (WasVisible, train/metrics/temporal_error.h). Windows lie
// on a grid of half their side; those of a kind are of different frames.
class WindowChooser {
 public:
  // `truth` as for SequenceJudge; it outlives the chooser.
  explicit WindowChooser(const Clip& truth) : truth_(truth) {}

  void Add(const ShownFrame& shown);

  // The heaviest first, of errors and then of disocclusions; windows that weigh nothing are left
  // out.
  std::vector<PictureWindow> Windows() const;

 private:
  const Clip& truth_;
  std::vector<PictureWindow> errors_, disocclusions_;  // the heaviest of each frame
  int width_ = 0, height_ = 0;                         // of the images
};

// One picture for each window: the true frame, then every method that showed it in that size, in
// the order they came.
class SequencePictures {
 public:
  SequencePictures(const Clip& truth, std::vector<PictureWindow> windows);

  void Add(const std::string& method, const ShownFrame& shown);

  // Writes FOLDER/SEQUENCE-NUMBER-KIND.png for each and returns one line for each: the file and its
  // panels from left to right.
  std::vector<std::string> Write(const std::filesystem::path& folder) const;

 private:
  struct Picture {
    PictureWindow window;
    std::vector<std::string> names;
    std::vector<Image> panels;
  };
  const Clip& truth_;
  std::vector<Picture> pictures_;
};

}  // namespace warplut
