#include "tools/pictures/hud_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "datasets/error.h"
#include "runtime/hud.h"
#include "train/replay/image_views.h"

namespace warplut {

HudLayer::HudLayer(const Sequence& sequence, int first, Executor& executor)
    : sequence_(sequence), first_(first), executor_(executor) {}

ShownFrame HudLayer::Over(const ShownFrame& shown) {
  if (!sequence_.hud) return shown;
  const ImageView& image = shown.image;
  if (image.width != sequence_.output.width || image.height != sequence_.output.height) {
    throw Error(fmt::format(
        "the frames that are shown of '{}' are {} x {}, and its HUD is on the output grid, {} x "
        "{}; expected a method that shows that grid, or no stream 'hud'",
        sequence_.name, image.width, image.height, sequence_.output.width,
        sequence_.output.height));
  }
  const int index =
      std::min(first_ + static_cast<int>(std::floor(shown.time + 0.5)), sequence_.count - 1);
  if (index != loaded_) {
    hud_ = ToBuffer(LoadFrame(sequence_, index, Streams::kHud).hud, PixelFormat::kRgba32F);
    loaded_ = index;
  }
  if (drawn_.bytes() == 0) drawn_ = ImageBuffer(image.width, image.height, image.format);
  CopyPixels(image, drawn_.view());
  const bool linear = sequence_.color_space == ColorSpace::kLinear;
  DrawHud(hud_.view(), linear ? ColorEncoding::kLinearHdr : ColorEncoding::kDisplay, executor_,
          drawn_.view());
  ShownFrame with_hud = shown;
  with_hud.image = drawn_.view();
  return with_hud;
}

}  // namespace warplut
