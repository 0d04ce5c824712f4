// The error budget of super resolution, against the exact depth, motion and references of the
// output grid.
#pragma once

#include "runtime/executor.h"
#include "runtime/super_resolution.h"
#include "tools/report/budget/budget_ladder.h"
#include "train/replay/clip.h"

namespace warplut {

// Over all frames but the first and those after a cut. With R the reference, O what super
// resolution shows, m the exact motion of the output grid, C the current frame alone, and H the
// last O warped by the motion that super resolution upsampled:
//   0  O, with the motion of the render grid stored in halves (MotionStorage::kHalf)
//   1  O, with it stored in two bytes (MotionStorage::kBytes)
//   2  O, with exact motion of the render grid
//   3  R where the frame before did not show the surface (WasVisible of
//     train/metrics/temporal_error.h)
//   4  R as well where the reference before, warped by m, has another local luma (kShadingChange)
//     although it is visible
//   5  elsewhere the best blend of C and H for the pixels around each
//     (BestBlend with kBlendRadius), or O where that is better
//   6  the best blend at every pixel for itself, or O
//   7  the same, the last O warped by m
//   8  a loop without coarse samples: x = W + share (R - W) from x = R on, W = x before, warped by
//     m, with the share of the residual
//      form at each pixel; x = R wherever rungs 3 or 4 put R
const BudgetPlan& SuperResolutionPlan();

// `options`: valid, with history, of the clip's sizes and encoding (EffectiveSuperResolution). The
// clip has every stream. Error if there is no such frame.
ErrorBudget SuperResolutionBudget(const Clip& clip, const SuperResolutionOptions& options,
                                  Executor& executor);

inline constexpr int kBlendRadius = 4;

}  // namespace warplut
