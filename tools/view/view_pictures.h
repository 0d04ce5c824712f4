// Pictures of what two sources show: a sheet of frames, and the windows where they err most.
#pragma once

#include <string>
#include <vector>

#include "tools/pictures/picture_window.h"
#include "tools/view/viewed_frames.h"

namespace warplut {

inline constexpr int kThumbnailWidth = 480;  // pixels of a panel of the sheet

// A picture with its label: an image, or an error in colours.
struct NamedPanel {
  std::string name;
  Image image;
  std::string note = {};  // of an error: how large it is drawn

  std::string Label() const { return note.empty() ? name : name + " " + note; }
};

// What is shown of a moment: both sources, the reference if there is one, and the errors, of both
// against the reference or of the one against the other.
std::vector<NamedPanel> PanelsOf(const ViewedFrames& frames, const ViewedFrame& frame,
                                 double amplify);

// The same window of every panel, enlarged, labelled, side by side below a title.
Image WindowPicture(const std::string& title, const std::vector<NamedPanel>& panels,
                    const PictureWindow& window);

// All panels in their size, labelled: images in the upper row, errors in the lower one.
Image MomentPicture(const std::string& frame, const std::vector<NamedPanel>& panels);

// Rows of panels, each at most kThumbnailWidth wide, with the name of their frame. At least one
// row; all rows have the same panels.
class ContactSheet {
 public:
  void Add(const std::string& frame, const std::vector<NamedPanel>& panels);
  // Below a title.
  Image Picture(const std::string& title) const;

 private:
  std::vector<Image> rows_;
};

// How both sources do, moment by moment: finds the moment and the window where each errs most
// (against the reference, or one against the other).
struct WorstWindow {
  std::string source;  // that errs
  std::size_t index = 0;
  PictureWindow window;
};
class WorstWindows {
 public:
  explicit WorstWindows(const ViewedFrames& frames) : frames_(frames) {}

  void Add(std::size_t index, const ViewedFrame& frame);

  // One of each source with a reference, else one; none where nothing differs.
  std::vector<WorstWindow> Worst() const;

 private:
  const ViewedFrames& frames_;
  WorstWindow a_, b_;
};

// The mean squared error over the frame and R, G, B, as a PSNR in dB; infinite for equal images.
double PsnrOf(const Image& image, const Image& truth);

}  // namespace warplut
