// Windows of images, enlarged and side by side for the eye.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datasets/image.h"

namespace warplut {

inline constexpr int kWindowSide = 96;      // pixels of the image
inline constexpr int kWindowZoom = 3;       // pixels of a picture per pixel
inline constexpr int kPicturePanelGap = 8;  // pixels of a picture

// A window of one frame, with its upper left corner; smaller images are taken whole.
struct PictureWindow {
  std::string kind;  // "error" or "disocclusion"
  int frame = 0;     // index in the clip
  int x = 0, y = 0;
  double weight = 0;  // squared error in it, or number of pixels that were not visible before
  int image_width = 0, image_height = 0;  // of the image that it lies in
};

// The heaviest window of a frame of width x height pixels that weigh `weight(x, y)` >= 0. Windows
// lie on a grid of half their side. Its image_width and image_height stay 0.
PictureWindow HeaviestWindow(const char* kind, int frame, int width, int height,
                             const std::function<double(int x, int y)>& weight);

// The sum over R, G, B of the squared difference of two images of one size at (x, y).
double SquaredDifference(const Image& a, const Image& b, int x, int y);

// The window of `image` (3 channels), every pixel kWindowZoom times in each axis.
Image EnlargedWindow(const Image& image, const PictureWindow& window);

// Panels (3 channels) of one height in a row on white, kPicturePanelGap apart; at least one.
Image SideBySide(const std::vector<Image>& panels);

}  // namespace warplut
