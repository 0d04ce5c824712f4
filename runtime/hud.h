// A HUD: an interface that is drawn over shown frames and does not move with the world.
//
// Where it is a layer of its own it goes through no warp and no blend: frames are generated without
// it, and it is drawn over them.
//   image = hud + (1 - alpha) image        per channel R, G, B
// in the encoding of the image: on display values with kDisplay, on linear light with kLinearHdr.
#pragma once

#include <string>

#include "luts/visibility.h"
#include "runtime/color_encoding.h"
#include "runtime/executor.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Draws `hud` over `image`, whose alpha is kept. Both are RGBA8, RGBA16F or RGBA32F, of one size.
// The colours of the HUD are multiplied by its alpha already (premultiplied). Its alpha is limited
// to [0, 1], its colours like those of frames (kDisplay: to [0, 1], kLinearHdr: LimitHdr); NaN
// counts as 0. Where all four channels are 0 the image keeps its bits. A HUD without data draws
// nothing. Any executor gives the same bits. Allocates nothing.
void DrawHud(const ImageView& hud, ColorEncoding encoding, Executor& executor,
             const MutableImageView& image);

// Whether DrawHud takes these images; otherwise *why (if not null) gets the reason.
bool IsDrawable(const ImageView& hud, const MutableImageView& image, std::string* why = nullptr);

}  // namespace warplut
