#include "tools/payoff/payoff_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "tools/judge/score_columns.h"
#include "tools/profile/profile_request.h"

namespace warplut {
namespace {

constexpr int kSsimDigits = 4, kPsnrDigits = 2;

std::vector<double> ScoresOf(const SequenceScores& scores, double FrameScore::*member) {
  std::vector<double> values;
  for (const FrameScore& frame : scores.frames) values.push_back(frame.*member);
  return values;
}

PayoffTable TableOf(const std::vector<PipelineVariant>& variants, const SequenceReport& report) {
  PayoffTable table{.sequence = report.sequence, .rows = {}};
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const SequenceScores &own = report.methods[i], &base = report.methods[variants[i].base];
    const auto difference = [&](double FrameScore::*member) {
      return DifferenceOver(ScoresOf(own, member), ScoresOf(base, member));
    };
    table.rows.push_back({.name = own.method,
                          .kind = variants[i].kind,
                          .base = base.method,
                          .scores = own,
                          .ssim = difference(&FrameScore::ssim),
                          .psnr = difference(&FrameScore::psnr)});
  }
  return table;
}

PayoffTable MeanTable(const std::vector<PayoffTable>& tables, const SequenceReport& mean) {
  PayoffTable table{.sequence = mean.sequence, .rows = tables.front().rows};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    std::vector<FrameDifference> ssim, psnr;
    for (const PayoffTable& one : tables) {
      ssim.push_back(one.rows[i].ssim);
      psnr.push_back(one.rows[i].psnr);
    }
    table.rows[i].scores = mean.methods[i];
    table.rows[i].ssim = MeanDifference(ssim);
    table.rows[i].psnr = MeanDifference(psnr);
  }
  return table;
}

std::string WithError(const FrameDifference& gain, int digits) {
  const std::string error =
      gain.HasError() ? fmt::format(" +- {:.{}f}", gain.standard_error, digits) : "";
  return SignedCell(gain.mean, digits).text + error;
}

// "+0.0123 +- 0.0010 of SSIM, +0.30 +- 0.02 dB" and why that decides nothing.
std::string GainText(const PayoffVerdict& verdict) {
  std::string text = fmt::format("{} of SSIM, {} dB", WithError(verdict.ssim, kSsimDigits),
                                 WithError(verdict.psnr, kPsnrDigits));
  if (verdict.subject != VariantKind::kPass) text += " against " + verdict.against;
  if (verdict.payoff != Payoff::kCannotTell) return text;
  if (!verdict.ssim.HasError()) {
    return text +
           fmt::format(" ({} frames, {} are needed)", verdict.ssim.frames, kLeastDifferingFrames);
  }
  return text +
         fmt::format(" ({} frames worth {:.1f})", verdict.ssim.frames, verdict.ssim.independent);
}

std::string Sentence(const std::string& subject, const std::string& place,
                     const PayoffVerdict& verdict) {
  const std::string where = place.empty() ? "" : " in " + place;
  const std::string gain = GainText(verdict);
  switch (verdict.payoff) {
    case Payoff::kPays:
      return fmt::format("{} pays{}: {}.", subject, where, gain);
    case Payoff::kDoesNotPay:
      return fmt::format("{} does not pay{}: {}.", subject, where, gain);
    case Payoff::kCannotTell:
      return fmt::format("{}: cannot tell whether it pays{}: {}.", subject, where, gain);
  }
  return {};
}

class VerdictMaker {
 public:
  VerdictMaker(const std::vector<PipelineVariant>& variants, const PayoffTable& table,
               double within)
      : variants_(variants), table_(table), within_(within) {}

  // The base of `rows` against the one of them whose SSIM is largest.
  void AddAgainstBest(VariantKind kind, std::size_t base, const std::string& name,
                      const std::string& subject, bool in_method) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < variants_.size(); ++i) {
      if (variants_[i].kind != kind || variants_[i].base != base || i == base) continue;
      if (!best || table_.rows[i].ssim.mean > table_.rows[*best].ssim.mean) best = i;
    }
    if (best) Add(kind, *best, name, subject, in_method);
  }

  void AddPasses(std::size_t base) {
    for (std::size_t i = 0; i < variants_.size(); ++i) {
      const PipelineVariant& variant = variants_[i];
      if (variant.kind != VariantKind::kPass || variant.base != base) continue;
      Add(VariantKind::kPass, i, variant.change, "The pass " + variant.change, true);
    }
  }

  std::vector<PayoffVerdict> verdicts;

 private:
  // Whether the base of the row gains against the row.
  void Add(VariantKind kind, std::size_t row, const std::string& name, const std::string& subject,
           bool in_method) {
    PayoffVerdict& verdict = verdicts.emplace_back();
    verdict.subject = kind;
    verdict.name = name;
    verdict.method = table_.rows[row].base;
    verdict.against = table_.rows[row].name;
    verdict.ssim = Reversed(table_.rows[row].ssim);
    verdict.psnr = Reversed(table_.rows[row].psnr);
    verdict.payoff = PayoffOf(verdict.ssim, within_);
    verdict.sentence = Sentence(subject, in_method ? verdict.method : "", verdict);
  }

  const std::vector<PipelineVariant>& variants_;
  const PayoffTable& table_;
  const double within_;
};

const Columns<PayoffRow> kColumns = {
    {"kind", "", [](const PayoffRow& row) { return TextCell(Name(row.kind)); }},
    {"base", "", [](const PayoffRow& row) { return TextCell(row.base); }},
    {"psnr", "PSNR dB", [](const PayoffRow& row) { return PsnrCell(row.scores.mean.psnr); }},
    {"ssim", "SSIM",
     [](const PayoffRow& row) { return NumberCell(row.scores.mean.ssim, kSsimDigits); }},
    {"temporal_error", "temporal",
     [](const PayoffRow& row) { return NumberCell(row.scores.temporal_error, 4); }},
    {"psnr_difference", "dPSNR",
     [](const PayoffRow& row) { return SignedCell(row.psnr.mean, kPsnrDigits); }},
    {"psnr_standard_error", "+-",
     [](const PayoffRow& row) { return NumberCell(row.psnr.standard_error, kPsnrDigits); }},
    {"ssim_difference", "dSSIM",
     [](const PayoffRow& row) { return SignedCell(row.ssim.mean, kSsimDigits); }},
    {"ssim_standard_error", "+-",
     [](const PayoffRow& row) { return NumberCell(row.ssim.standard_error, kSsimDigits); }},
    {"frames", "frames",
     [](const PayoffRow& row) {
       return Cell{.value = row.ssim.frames, .text = fmt::format("{}", row.ssim.frames)};
     }},
    {"independent_frames", "worth",
     [](const PayoffRow& row) { return NumberCell(row.ssim.independent, 1); }},
};

Json ToJson(const PayoffVerdict& verdict) {
  return {{"subject", Name(verdict.subject)},
          {"name", verdict.name},
          {"method", verdict.method},
          {"against", verdict.against},
          {"verdict", Name(verdict.payoff)},
          {"ssim_gain", FiniteJson(verdict.ssim.mean)},
          {"ssim_standard_error", FiniteJson(verdict.ssim.standard_error)},
          {"psnr_gain", FiniteJson(verdict.psnr.mean)},
          {"psnr_standard_error", FiniteJson(verdict.psnr.standard_error)},
          {"independent_frames", FiniteJson(verdict.ssim.independent)},
          {"sentence", verdict.sentence}};
}

}  // namespace

PayoffReport MakePayoffReport(const std::vector<PipelineVariant>& variants,
                              const std::vector<SequenceReport>& reports, const std::string& filter,
                              bool from_table, const std::string& parameters) {
  PayoffReport report{.within = kDefaultWithin, .tables = {}, .verdicts = {}};
  for (const SequenceReport& one : reports) report.tables.push_back(TableOf(variants, one));
  if (reports.size() > 1) report.tables.push_back(MeanTable(report.tables, MeanReport(reports)));
  VerdictMaker maker(variants, report.tables.back(), report.within);
  const std::string filter_subject = (from_table ? "The table " : "The filter ") + filter;
  const std::string parameters_name =
      parameters.empty() ? "built-in parameters" : "calibration " + parameters;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (variants[i].base != i) continue;
    maker.AddAgainstBest(VariantKind::kFilter, i, filter, filter_subject, true);
    maker.AddAgainstBest(VariantKind::kParameterSet, i, parameters_name,
                         (parameters.empty() ? "The set of " : "The ") + parameters_name, true);
    maker.AddPasses(i);
    maker.AddAgainstBest(VariantKind::kMethod, i, variants[i].run.name,
                         "The method " + variants[i].run.name, false);
  }
  report.verdicts = std::move(maker.verdicts);
  return report;
}

TextTable ToTable(const PayoffTable& table) {
  TextTable text = RecordTable(kColumns, table.rows);
  text.header.insert(text.header.begin(), table.sequence);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const PayoffRow& row = table.rows[i];
    const bool alone = row.base == row.name;
    if (alone) {
      // Differences of a row to itself say nothing.
      for (std::size_t c = 0; c < text.rows[i].size(); ++c) {
        const std::string& heading = text.header[c + 1];
        if (heading.starts_with('d') || heading == "+-" || heading == "worth") {
          text.rows[i][c] = "";
        }
      }
    }
    text.rows[i].insert(text.rows[i].begin(), row.name);
  }
  return text;
}

std::string PayoffText(const PayoffReport& report, bool markdown) {
  std::string text;
  for (const PayoffVerdict& verdict : report.verdicts) {
    text += (markdown ? "- " : "") + verdict.sentence + "\n";
  }
  return text + "\n" +
         fmt::format(
             "Differences are to the method as given, frame by frame; +- is the standard error of "
             "their "
             "mean. Neighbouring frames are alike, so a row tells as much as 'worth' independent "
             "frames. "
             "A gain of SSIM pays where it is beyond the 99.5 % quantile of Student's t; it does "
             "not pay "
             "where it is {} at most within the same error.\n",
             report.within);
}

Json ToJson(const PayoffReport& report) {
  Json tables = Json::array(), verdicts = Json::array();
  for (const PayoffTable& table : report.tables) {
    Json rows = Json::array();
    for (const PayoffRow& row : table.rows) {
      rows.push_back({{"name", row.name}});
      rows.back().update(RecordJson(kColumns, row));
    }
    tables.push_back({{"sequence", table.sequence}, {"rows", rows}});
  }
  for (const PayoffVerdict& verdict : report.verdicts) verdicts.push_back(ToJson(verdict));
  return {{"within", report.within}, {"tables", tables}, {"verdicts", verdicts}};
}

}  // namespace warplut
