// A scene of any length from numbers that are exact in float, and so the same with every compiler:
// a ground that pans, and a nearer square that moves the other way.
#pragma once

#include "train/replay/clip.h"

namespace warplut {

// Buffers of a frame with every stream: 24 x 18 pixels, references of twice the size.
ClipFrame GoldenFrame();

// Fills every stream with frame `number`, at its jitter. Frame 0 is a cut.
void RenderGoldenFrame(int number, ClipFrame& frame);

Clip GoldenClip(int frames);

}  // namespace warplut
