#include "tools/pictures/lut_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace warplut {
namespace {

using Color = std::array<float, 3>;

constexpr Color kPositive = {0.80f, 0.33f, 0.00f};
constexpr Color kNegative = {0.00f, 0.27f, 0.65f};
constexpr float kGapGrey = 0.35f;
constexpr int kTile = kNodes * kPictureZoom;

Color WeightColor(float weight) {
  const float depth = std::min(1.0f, std::sqrt(std::abs(weight)));
  const Color& full = weight < 0 ? kNegative : kPositive;
  Color color;
  for (int c = 0; c < 3; ++c) color[c] = 1.0f + depth * (full[c] - 1.0f);
  return color;
}

}  // namespace

int LutPictureSide(Footprint footprint) {
  const int taps = AxisTaps(footprint);
  return taps * kTile + (taps + 1) * kPictureGap;
}

Image LutPicture(Footprint footprint, const std::vector<Weights<float>>& rows) {
  const int side = LutPictureSide(footprint);
  Image picture(side, side, 3);
  std::fill(picture.data.begin(), picture.data.end(), kGapGrey);
  for (const int k : TapsOf(footprint)) {
    const int left = kPictureGap + (TapX(k) - FirstAxisTap(footprint)) * (kTile + kPictureGap);
    const int top = kPictureGap + (TapY(k) - FirstAxisTap(footprint)) * (kTile + kPictureGap);
    for (int y = 0; y < kTile; ++y) {
      for (int x = 0; x < kTile; ++x) {
        const int row = RowIndex(x / kPictureZoom, y / kPictureZoom);
        const Color color = WeightColor(rows[static_cast<std::size_t>(row)][k]);
        for (int c = 0; c < 3; ++c) picture.at(left + x, top + y, c) = color[c];
      }
    }
  }
  return picture;
}

}  // namespace warplut
