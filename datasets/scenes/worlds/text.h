// Lettering: a 5 x 7 bitmap font, looked up through an exact box filter.
#pragma once

#include <string>
#include <vector>

#include "datasets/scenes/linear.h"

namespace warplut::scenes {

// Lines of text as a bitmap. Coordinates are in bitmap texels: x right, y up from the lower edge.
// A character takes 6 x 9 texels; a margin of 2 texels surrounds the text.
class Text {
 public:
  // Letters are upper case; a character that the font lacks is blank. Lines are separated by '\n'.
  explicit Text(const std::string& lines);

  int width() const { return width_; }
  int height() const { return height_; }
  // Mean ink, 0 to 1, in the box of this width centred on p. Outside the bitmap there is no ink.
  float Ink(Vec2f p, float footprint) const;

 private:
  // Ink to the left of and below p, by bilinear lookup in the summed-area table.
  float Sum(float x, float y) const;

  int width_, height_;
  std::vector<float> sums_;  // (width + 1) x (height + 1)
};

}  // namespace warplut::scenes
