// What content pays for: the variants, and the sentences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/payoff/payoff_report.h"
#include "tools/pipeline.h"

namespace warplut {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

VariantOptions Options(const std::vector<std::string>& methods,
                       const std::vector<std::string>& against) {
  VariantOptions options;
  for (const std::string& name : methods) options.methods.push_back(&MethodOf(name));
  options.against = against;
  return options;
}

PipelineArguments Arguments(const std::string& filter) {
  PipelineArguments arguments;
  arguments.filter = filter;
  return arguments;
}

std::vector<std::string> NamesOf(const PipelineVariants& variants) {
  std::vector<std::string> names;
  for (const PipelineVariant& variant : variants.list()) names.push_back(variant.run.name);
  return names;
}

TEST(PipelineVariants, AreFiltersParametersPassesAndMethods) {
  VariantOptions options = Options({"sr"}, {"bilinear", "keys:-0.65", "catmull-rom", "taau"});
  options.beside = {&MethodOf("bicubic")};
  const PipelineVariants variants(options, Arguments("catmull-rom"));
  const std::vector<std::string> names = NamesOf(variants);
  for (const char* name :
       {"sr", "sr with bilinear", "sr with keys:-0.65", "sr with published parameters",
        "sr without color-box", "sr without motion-filter", "taau", "bicubic"}) {
    EXPECT_THAT(names, Contains(name));
  }
  for (const char* name : {"sr with catmull-rom", "sr with built-in parameters", "sr without table",
                           "sr without table-and-cubic"}) {
    EXPECT_THAT(names, Not(Contains(name)));
  }
  for (const PipelineVariant& variant : variants.list()) {
    EXPECT_EQ(variant.base, 0U) << variant.run.name;
  }
}

TEST(PipelineVariants, MethodsOfAnotherKindHaveNoBase) {
  const PipelineVariants variants(Options({"sr", "i"}, {"bilinear", "repeat"}),
                                  Arguments("catmull-rom"));
  const auto find = [&](const std::string& name) -> const PipelineVariant& {
    return *std::find_if(variants.list().begin(), variants.list().end(),
                         [&](const PipelineVariant& one) { return one.run.name == name; });
  };
  EXPECT_EQ(variants.list()[find("repeat").base].run.name, "i");
  EXPECT_EQ(variants.list()[find("i with bilinear").base].run.name, "i");
  EXPECT_THAT(NamesOf(variants), Not(Contains("i without motion-filter")));
  const PipelineVariants alone(Options({"sr"}, {"repeat"}), Arguments("catmull-rom"));
  EXPECT_EQ(alone.list().back().run.name, "repeat");
  EXPECT_EQ(alone.list().back().base, alone.list().size() - 1);
}

TEST(PipelineVariants, RefuseWhatIsNothing) {
  ExpectError([] { CheckAgainst(Options({"sr"}, {"keys:2"})); }, {"'keys:2'", "table", "method"});
  ExpectError([] { CheckAgainst(Options({"bicubic"}, {"keys:-0.6"})); },
              {"'keys:-0.6'", "no method"});
  CheckAgainst(Options({"bicubic"}, {"taau"}));
}

// Reports of two sequences of eight frames, in which each variant has an own SSIM.
std::vector<SequenceReport> Reports(const std::vector<PipelineVariant>& variants,
                                    const std::map<std::string, double>& ssim, double noise) {
  std::vector<SequenceReport> reports;
  for (int s = 0; s < 2; ++s) {
    SequenceReport& report = reports.emplace_back();
    report.sequence = s == 0 ? "first" : "second";
    for (const PipelineVariant& variant : variants) {
      SequenceScores& scores = report.methods.emplace_back();
      scores.method = variant.run.name;
      const auto own = ssim.find(variant.run.name);
      for (int i = 0; i < 8; ++i) {
        const double value = own == ssim.end() ? 0.9 : own->second + (i % 2 == 0 ? noise : -noise);
        scores.frames.push_back({.name = "f", .psnr = 30 * value, .ssim = value});
      }
      scores.mean = MeanScore(scores.frames);
    }
  }
  return reports;
}

PayoffReport ReportOf(const PipelineVariants& variants, const std::map<std::string, double>& ssim,
                      double noise = 0.001) {
  return MakePayoffReport(variants.list(), Reports(variants.list(), ssim, noise), "catmull-rom",
                          false, "");
}

const PayoffVerdict& VerdictOn(const PayoffReport& report, const std::string& name) {
  const auto found =
      std::find_if(report.verdicts.begin(), report.verdicts.end(),
                   [&](const PayoffVerdict& verdict) { return verdict.name == name; });
  if (found == report.verdicts.end()) throw Error("no verdict on " + name);
  return *found;
}

class Payoffs : public testing::Test {
 protected:
  static VariantOptions All() {
    VariantOptions options = Options({"sr"}, {"bilinear", "keys:-0.65"});
    options.beside = {&MethodOf("bicubic")};
    return options;
  }
  const PipelineVariants variants_{All(), Arguments("catmull-rom")};
};

TEST_F(Payoffs, TheFilterIsJudgedAgainstTheBestOfTheOthers) {
  const PayoffReport report =
      ReportOf(variants_, {{"sr with bilinear", 0.8}, {"sr with keys:-0.65", 0.89}});
  const PayoffVerdict& filter = VerdictOn(report, "catmull-rom");
  EXPECT_EQ(filter.payoff, Payoff::kPays);
  EXPECT_EQ(filter.against, "sr with keys:-0.65");
  EXPECT_NEAR(filter.ssim.mean, 0.01, 1e-9);
  EXPECT_NEAR(filter.psnr.mean, 0.3, 1e-9);
  EXPECT_THAT(filter.sentence, HasSubstr("The filter catmull-rom pays in sr: +0.0100 +- "));
}

TEST_F(Payoffs, EachQuestionHasAnAnswer) {
  const PayoffReport report = ReportOf(variants_, {{"sr with bilinear", 0.8},
                                                   {"sr with keys:-0.65", 0.8997},
                                                   {"sr with published parameters", 0.91},
                                                   {"sr without color-box", 0.85},
                                                   {"bicubic", 0.8}});
  EXPECT_EQ(VerdictOn(report, "catmull-rom").payoff, Payoff::kCannotTell);
  EXPECT_THAT(VerdictOn(report, "catmull-rom").sentence, HasSubstr("cannot tell whether it pays"));
  EXPECT_EQ(VerdictOn(report, "built-in parameters").payoff, Payoff::kDoesNotPay);
  EXPECT_EQ(VerdictOn(report, "color-box").payoff, Payoff::kPays);
  EXPECT_THAT(VerdictOn(report, "color-box").sentence, HasSubstr("The pass color-box pays in sr"));
  EXPECT_EQ(VerdictOn(report, "half-float-history").payoff, Payoff::kDoesNotPay);
  EXPECT_THAT(VerdictOn(report, "half-float-history").sentence, HasSubstr("does not pay"));
  EXPECT_EQ(VerdictOn(report, "sr").payoff, Payoff::kPays);
  for (const PayoffVerdict& verdict : report.verdicts) EXPECT_THAT(verdict.sentence.back(), '.');
}

TEST_F(Payoffs, SeveralSequencesHaveAMean) {
  const PayoffReport report = ReportOf(variants_, {{"bicubic", 0.8}});
  ASSERT_EQ(report.tables.size(), 3U);
  EXPECT_EQ(report.tables.back().sequence, "mean");
  const TextTable table = ToTable(report.tables.back());
  ASSERT_EQ(table.rows.size(), variants_.list().size());
  EXPECT_EQ(table.header.front(), "mean");
  EXPECT_EQ(table.rows.front()[4], "") << "the base has no difference to itself";
  EXPECT_EQ(table.rows.back()[6], "-0.1000");
  EXPECT_EQ(report.tables.back().rows.back().ssim.frames, 16);
  const auto json = ToJson(report);
  EXPECT_EQ(json["tables"][2]["rows"][0]["kind"], "shipped");
  EXPECT_EQ(json["verdicts"].size(), report.verdicts.size());
  EXPECT_THAT(PayoffText(report, true), HasSubstr("- The filter catmull-rom "));
}

// The judged variants are the runs that the command line would make one by one.
TEST(JudgedVariants, AreWhatOneByOneIsJudged) {
  const TemporaryFolder folder;
  const std::vector<Sequence> sequences = {WritePan(folder / "pan", {.frames = 4})};
  const auto judge = [&](const std::string& filter, std::vector<JudgedRun> runs) {
    const PipelineArguments arguments = Arguments(filter);
    return JudgeSequences({.runs = std::move(runs), .pipeline = arguments}, Pipeline(arguments),
                          sequences)
        .reports.front();
  };
  const auto ssim = [](const SequenceReport& report, const std::string& name) {
    for (const SequenceScores& scores : report.methods) {
      if (scores.method == name) return scores.mean.ssim;
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  const PipelineVariants variants(Options({"sr"}, {"bilinear"}), Arguments("catmull-rom"));
  const SequenceReport judged = judge("catmull-rom", variants.runs());
  const std::vector<JudgedRun> sr = RunsOf({&MethodOf("sr")});
  EXPECT_EQ(ssim(judged, "sr"), ssim(judge("catmull-rom", sr), "sr"));
  EXPECT_EQ(ssim(judged, "sr with bilinear"), ssim(judge("bilinear", sr), "sr"));
  EXPECT_NE(ssim(judged, "sr with bilinear"), ssim(judged, "sr"));
  EXPECT_LT(ssim(judged, "sr without history"), ssim(judged, "sr"));
  EXPECT_EQ(ssim(judged, "sr without motion-filter"), ssim(judged, "sr"))
      << "the motion is not quantised";
}

}  // namespace
}  // namespace warplut
