// Columns of the scores of frames.
#pragma once

#include "tools/judge/sequence_scores.h"
#include "tools/tables/record_table.h"

namespace warplut {

// A score with its temporal error, NaN where a frame has none.
struct TimedScore {
  FrameScore score;
  double temporal_error = 0;
};

// PSNR (RGB) and SSIM (luma).
inline const Columns<TimedScore> kFrameColumns = {
    {"psnr", "PSNR dB", [](const TimedScore& timed) { return PsnrCell(timed.score.psnr); }},
    {"ssim", "SSIM", [](const TimedScore& timed) { return NumberCell(timed.score.ssim, 4); }}};

// The same and the temporal error.
inline const Columns<TimedScore> kScoreColumns = {
    kFrameColumns[0], kFrameColumns[1], {"temporal_error", "temporal", [](const TimedScore& timed) {
                                           return NumberCell(timed.temporal_error, 4);
                                         }}};

// Columns of `judge --jitter`.
inline const Columns<JitterScores> kJitterColumns = {
    {"jitter_error", "jitter",
     [](const JitterScores& scores) { return NumberCell(scores.repeating, 5); }},
    {"lattice_error", "lattice",
     [](const JitterScores& scores) { return NumberCell(scores.lattice, 5); }}};

}  // namespace warplut
