// The alpha of the frames that a method shows.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "datasets/image.h"
#include "runtime/executor.h"
#include "train/replay/mode_run.h"

namespace warplut {

// The alpha of one frame, row by row; 65535 is opaque.
using ShownAlpha = std::vector<std::uint16_t>;

// One channel from 0 to 1, of the size of the frame.
Image ToImage(const ShownAlpha& alpha, int width, int height);

// The stream with the alpha of the colour that the method takes of the sequence; kNone if there is
// none.
Streams AlphaStreamOf(const Sequence& sequence, const MethodInfo& method);

// The alpha of every frame that RunMode shows of the clip with these options, in its order: the
// same passes over a grey image. The clip has been loaded with the stream `alpha` and is as before
// afterwards. `on_frame` is called once for each frame; what it throws ends the work.
std::vector<ShownAlpha> RunAlpha(Clip& clip, Streams alpha, const ModeRunOptions& options,
                                 Executor& executor, const std::function<void()>& on_frame);

}  // namespace warplut
