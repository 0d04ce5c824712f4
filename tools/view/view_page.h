// A page on which frames are compared by eye. It needs no other file.
#pragma once

#include <string>
#include <vector>

namespace warplut {

// One image of a moment: its PNG file as bytes.
struct PageLayer {
  std::string name;
  std::string png;
};

// Layers of one size and place, of which two are shown at a time, one on each side of a slider. At
// least two; the first two are shown first.
struct PageMoment {
  std::string id;  // of its anchor: unique, lower case, digits and hyphens
  std::string title;
  std::string caption;
  std::vector<PageLayer> layers;
};

// The page: paragraphs, then the moments. The reader chooses the layers of the two sides, moves the
// border, flips from one side to the other (the button, or the space key) and enlarges pixels.
// Without scripts the first two layers are shown, half and half.
std::string ViewPage(const std::string& title, const std::vector<std::string>& paragraphs,
                     const std::vector<PageMoment>& moments);

}  // namespace warplut
