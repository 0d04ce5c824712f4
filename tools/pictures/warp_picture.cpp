#include "tools/pictures/warp_picture.h"

#include <algorithm>

#include "tools/judge/images/image_set.h"

namespace warplut {
namespace {

// Warps see this much more than is shown, so that edges do not reach the panel.
constexpr int kMargin = 64;

Image Channel(const Image& image, int channel) {
  Image plane(image.width, image.height, 1);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    plane.data[pixel] = image.data[pixel * image.channels + channel];
  }
  return plane;
}

// Copies channel c of a panel that starts at column `left`; `plane` is already cut to the panel.
void Place(const Image& plane, int left, int c, Image& picture) {
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) picture.at(left + x, y, c) = plane.at(x, y);
  }
}

}  // namespace

Image WarpPicture(const Image& image, std::span<const ProtocolFilter> filters,
                  const Protocol& protocol, std::uint64_t seed) {
  const Image seen = CenterCrop(image, kPanelSide + 2 * kMargin);
  const int width = std::min(seen.width, kPanelSide);
  const int height = std::min(seen.height, kPanelSide);
  const int panels = 1 + static_cast<int>(filters.size());
  Image picture(panels * width + (panels - 1) * kPanelGap, height, 3);
  std::fill(picture.data.begin(), picture.data.end(), 1.0f);
  for (int c = 0; c < 3; ++c) {
    const Image plane = Channel(seen, std::min(c, image.channels - 1));
    Place(CenterCrop(plane, kPanelSide), 0, c, picture);
    for (int panel = 1; panel < panels; ++panel) {
      const Image warped = WarpRepeatedly(filters[panel - 1], protocol, plane, 0, 0, seed);
      Place(CenterCrop(warped, kPanelSide), panel * (width + kPanelGap), c, picture);
    }
  }
  return picture;
}

}  // namespace warplut
