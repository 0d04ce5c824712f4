// Scores of methods on sequences, as tables for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "tools/judge/sequence_scores.h"
#include "tools/tables/record_table.h"

namespace warplut {

// One sequence, every method on it in the same order; at least one method.
struct SequenceReport {
  std::string sequence;
  std::vector<SequenceScores> methods;
  std::vector<std::string> notes = {};  // JudgingNotes
};

// Rows: methods. Columns: PSNR (RGB), SSIM (luma), temporal error; the same settled, where all
// methods have that; errors that the jitter makes, where all have those; milliseconds per frame
// that the runtime made.
TextTable MethodTable(const SequenceReport& report);

// Rows: judged frames, their mean, and the settled mean if there is one.
TextTable FrameTable(const SequenceScores& scores);

// The means over sequences, each with the same weight, under the name "mean", settled ones and
// those of jitter too. At least one report; all have settled scores, without as many frames, or
// none, and all have scores of jitter or none.
SequenceReport MeanReport(const std::vector<SequenceReport>& reports);

Json ToJson(const SequenceReport& report);

// What a method must reach on every sequence.
struct SequenceTarget {
  std::string method;
  double psnr = 0;
  double ssim = 0;
};

// "METHOD,PSNR,SSIM", for example "sr,31.4,.930". An Error names anything else.
SequenceTarget ParseSequenceTarget(const std::string& text);

// One sentence for each sequence on which the target's method has a lower mean PSNR or SSIM.
std::vector<std::string> MissedSequences(const SequenceTarget& target,
                                         const std::vector<SequenceReport>& reports);

}  // namespace warplut
