// What content pays for: variants of pipelines beside each other, differences with their standard
// errors, and a sentence for the table, the parameters and each pass.
#pragma once

#include <string>
#include <vector>

#include "tools/judge/frame_difference.h"
#include "tools/judge/sequence_report.h"
#include "tools/payoff/pipeline_variants.h"

namespace warplut {

// One variant on one sequence, or on all of them.
struct PayoffRow {
  std::string name;
  VariantKind kind = VariantKind::kShipped;
  std::string base;                 // the name of the variant that it is compared with
  SequenceScores scores;            // the means alone
  FrameDifference ssim, psnr = {};  // its scores minus those of the base
};

struct PayoffTable {
  std::string sequence;  // "mean" for all of several
  std::vector<PayoffRow> rows;
};

struct PayoffVerdict {
  VariantKind subject = VariantKind::kFilter;  // of the question
  std::string name;     // of the filter, the parameters, the pass or the method that may pay
  std::string method;   // of the pipeline
  std::string against;  // the row that it is compared with
  Payoff payoff = Payoff::kCannotTell;
  FrameDifference ssim, psnr = {};  // gains
  std::string sentence;
};

struct PayoffReport {
  double within = 0;                // gains of SSIM up to this do not count
  std::vector<PayoffTable> tables;  // one for each sequence, then their mean if there are several
  std::vector<PayoffVerdict> verdicts;  // on all sequences
};

// `reports`: of the variants' runs, in their order, one for each sequence; at least one. `filter`:
// the name of the filter of the pipelines; `from_table`: whether it is a table. `parameters`: the
// name of the file of the parameters; empty: the built-in ones.
//
// Verdicts, by the SSIM, as everywhere where passes and parameters are chosen:
//   kFilter        the filter against the best other one, for each method
//   kParameterSet  the parameters against the best other ones, for each method
//   kPass          each pass against its method without it
//   kMethod        each method that was asked for against the best other one of its kind
PayoffReport MakePayoffReport(const std::vector<PipelineVariant>& variants,
                              const std::vector<SequenceReport>& reports, const std::string& filter,
                              bool from_table, const std::string& parameters);

// Rows: variants. Columns: scores, differences to the base of the row, standard errors, and how
// many independent frames the difference in SSIM rests on.
TextTable ToTable(const PayoffTable& table);

// The verdicts, one sentence in a line, and how they are made; as a list where it is Markdown.
std::string PayoffText(const PayoffReport& report, bool markdown);

Json ToJson(const PayoffReport& report);

}  // namespace warplut
