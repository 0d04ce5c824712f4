#include "tools/view/view_pictures.h"

#include <algorithm>
#include <utility>

#include "tools/view/error_map.h"
#include "tools/view/picture_label.h"
#include "train/metrics/psnr.h"

namespace warplut {
namespace {

// Pictures of one width or not, one above the other on white.
Image Stacked(const std::vector<Image>& rows) {
  int width = 0, height = 0;
  for (const Image& row : rows) {
    width = std::max(width, row.width);
    height += row.height + kPicturePanelGap;
  }
  Image picture(width, height - kPicturePanelGap, 3);
  std::fill(picture.data.begin(), picture.data.end(), 1.0f);
  int top = 0;
  for (const Image& row : rows) {
    for (int y = 0; y < row.height; ++y) {
      std::copy_n(&row.data[row.Index(0, y)], static_cast<std::size_t>(row.width) * 3,
                  &picture.data[picture.Index(0, top + y)]);
    }
    top += row.height + kPicturePanelGap;
  }
  return picture;
}

void KeepWorse(std::size_t index, const std::string& source, const Image& image, const Image& truth,
               WorstWindow& worst) {
  PictureWindow window =
      HeaviestWindow("error", static_cast<int>(index), image.width, image.height,
                     [&](int x, int y) { return SquaredDifference(image, truth, x, y); });
  if (window.weight <= worst.window.weight) return;
  worst = {.source = source, .index = index, .window = std::move(window)};
}

}  // namespace

std::vector<NamedPanel> PanelsOf(const ViewedFrames& frames, const ViewedFrame& frame,
                                 double amplify) {
  std::vector<NamedPanel> panels = {{frames.a, frame.a}, {frames.b, frame.b}};
  const auto add_error = [&](const std::string& name, const Image& image, const Image& truth) {
    panels.push_back({name, ErrorMap(image, truth, amplify), ErrorFactor(amplify)});
  };
  if (!frame.HasReference()) {
    add_error("difference", frame.a, frame.b);
    return panels;
  }
  panels.push_back({"reference", frame.reference});
  add_error("error of " + frames.a, frame.a, frame.reference);
  add_error("error of " + frames.b, frame.b, frame.reference);
  return panels;
}

Image WindowPicture(const std::string& title, const std::vector<NamedPanel>& panels,
                    const PictureWindow& window) {
  std::vector<Image> enlarged;
  for (const NamedPanel& panel : panels) {
    enlarged.push_back(Labelled(EnlargedWindow(panel.image, window), panel.Label()));
  }
  return Labelled(SideBySide(enlarged), title);
}

Image MomentPicture(const std::string& frame, const std::vector<NamedPanel>& panels) {
  std::vector<Image> images, errors;
  for (const NamedPanel& panel : panels) {
    (panel.note.empty() ? images : errors)
        .push_back(Labelled(panel.image, frame + "  " + panel.Label()));
  }
  return Stacked({SideBySide(images), SideBySide(errors)});
}

void ContactSheet::Add(const std::string& frame, const std::vector<NamedPanel>& panels) {
  std::vector<Image> labelled;
  for (const NamedPanel& panel : panels) {
    labelled.push_back(
        Labelled(AtMostWide(panel.image, kThumbnailWidth), frame + "  " + panel.Label()));
  }
  rows_.push_back(SideBySide(labelled));
}

Image ContactSheet::Picture(const std::string& title) const {
  return Labelled(Stacked(rows_), title);
}

void WorstWindows::Add(std::size_t index, const ViewedFrame& frame) {
  if (!frame.HasReference()) {
    KeepWorse(index, frames_.a, frame.a, frame.b, a_);
    return;
  }
  KeepWorse(index, frames_.a, frame.a, frame.reference, a_);
  KeepWorse(index, frames_.b, frame.b, frame.reference, b_);
}

std::vector<WorstWindow> WorstWindows::Worst() const {
  std::vector<WorstWindow> worst;
  for (const WorstWindow* one : {&a_, &b_}) {
    if (one->window.weight > 0) worst.push_back(*one);
  }
  return worst;
}

double PsnrOf(const Image& image, const Image& truth) {
  return Psnr(MeanSquaredError(image, truth, 0));
}

}  // namespace warplut
