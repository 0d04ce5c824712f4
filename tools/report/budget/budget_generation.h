// The error budget of generated frames, against the exact depth, motion and references of the
// frames that they stand for.
#pragma once

#include "runtime/executor.h"
#include "runtime/frame_generation.h"
#include "tools/report/budget/budget_ladder.h"
#include "train/replay/clip.h"
#include "train/replay/mode_run.h"

namespace warplut {

// Generated is the frame t between two rendered ones, or after the later one; every second frame of
// the clip is rendered. With R the reference of t, A the reference of frame t - 1 warped by the
// exact motion of t, and B that of t + 1 warped by the exact motion from t to it (ForwardMotionOf).
// A shows the surface where WasVisible of train/metrics/temporal_error.h says so, B where that
// motion is known:
//   0  the generated frame, with the motion of rendered frames stored in halves
//     (MotionStorage::kHalf)
//   1  the generated frame, with it stored in two bytes (MotionStorage::kBytes)
//   2  the generated frame, with exact motion of rendered frames
//   3  R where no source shows the surface
//   4  interpolation: where one source alone shows the surface, that one, of A and B
//   5  elsewhere A and B blended by time; extrapolation: A
//   6  R as well where no blend of those that show the surface has the local luma of R
//     (kShadingChange)
//   7  interpolation: elsewhere the best blend of those that show the surface, at every pixel
// Frames with a cut between them and one of their sources are left out.
const BudgetPlan& GenerationPlan(Generation generation);

// `dense` has the motion from frame to frame, `sparse` the same frames with motion over
// kReportEvery; both have the streams of the output grid. `options`: filter and parameters. Error
// if no frame is generated that can be judged.
ErrorBudget GenerationBudget(const Clip& dense, const Clip& sparse, Generation generation,
                             const FrameGenerationOptions& options, Executor& executor);

}  // namespace warplut
