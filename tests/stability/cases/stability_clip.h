// Clips that are made of formulas, the shipped tables as filters, and what images are compared by.
#pragma once

#include <functional>

#include "luts/contract.h"
#include "runtime/image_view.h"
#include "runtime/warp.h"
#include "train/replay/clip.h"

namespace warplut {

// What is seen at a point.
struct ClipTexel {
  float color[3] = {};
  float depth = 0.5f;
  double motion_x = 0, motion_y = 0;  // pixels of the render grid
};

// (x, y) in pixels of the render grid; pixel (i, j) has its centre at (i + 0.5, j + 0.5).
using ClipContent = std::function<ClipTexel(double x, double y, int frame)>;

// Buffers of a frame with every stream; without references where `output` is 0 x 0. Colours are
// RGBA32F.
ClipFrame MakeClipFrame(GridSize render, GridSize output);

// Fills every pixel of the streams that are there with frame `number` of the content.
void RenderClipFrame(const ClipContent& content, int number, Vec2 jitter, ClipFrame& frame);

// `frames` frames with the four jitters of an upscale factor of 2.
Clip MakeClip(GridSize render, GridSize output, int frames, const ClipContent& content);

// The jitter of frame `number` in a cycle of 4: the centres of the quarters of a pixel.
Vec2 QuarterJitter(int number);

// Smooth texture, values in [0.1, 0.9]. It repeats after `period` in both axes.
void Texture(double x, double y, double period, float color[3]);

// A value in [0, 1) that looks random.
float Noise(int x, int y, int frame);

// The shipped tables of factor 2, ready for the kernels: of objective `sr` (for histories) and of
// `warp`.
const Table& HistoryTable();
const Table& WarpTable();
// The stored form of the same.
const TableView& StoredHistoryTable();
const TableView& StoredWarpTable();

// The filter that looks up HistoryTable().
WarpOptions HistoryWarp(Lookup lookup = Lookup::kBilinear);

// The pixels of one row after the other; padding does not count.
bool SameBits(const ImageView& a, const ImageView& b);

// The largest difference of a channel, codes as value / 255; infinite where one is not a number.
// Sizes are equal.
double LargestDifference(const ImageView& a, const ImageView& b);

// The share of pixels with a channel that differs by more than `bound`.
double DifferingShare(const ImageView& a, const ImageView& b, double bound);

// The least and the largest value of the colour channels; least > largest if one is not a number.
struct ValueRange {
  double least = 0, largest = 0;

  bool IsWithin(double low, double high) const {
    return least <= largest && least >= low && largest <= high;
  }
};
ValueRange RangeOf(const ImageView& image);

// The largest difference of Warp from WarpReference for values in [0, 1], codes as value / 255
// (runtime/warp.h).
double WarpBound(PixelFormat format);

inline constexpr double kHalfCode = 0.5 / 255;

}  // namespace warplut
