#include "tools/judge/images/eval_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace warplut {
namespace {

EvalReport Report() {
  EvalReport report;
  report.protocols = {{.warps = 6, .offsets = Offsets::kHalf},
                      {.warps = 12, .offsets = Offsets::kPan}};
  report.judged = {.name = "lut", .ssim = {0.96, 0.94}, .parameters = {}};
  report.others = {{.name = "keys:-0.5", .ssim = {0.95, 0.92}, .parameters = {}},
                   {.name = kBestSpline,
                    .ssim = {0.97, 0.95},
                    .family = FindFamily(kBestSpline),
                    .parameters = {0.0119, 0.01}}};
  return report;
}

TEST(EvalReport, TheLastColumnIsTheMean) {
  EXPECT_EQ(ToMarkdown(ScoreTable(Report())),
            "| SSIM after | 6 half | 12 pan | mean |\n|---|---:|---:|---:|\n"
            "| keys:-0.5 | 0.9500 | 0.9200 | 0.9350 |\n"
            "| best-spline | 0.9700 | 0.9500 | 0.9600 |\n"
            "|   its k | 0.0119 | 0.0100 |  |\n"
            "| lut | 0.9600 | 0.9400 | 0.9500 |\n"
            "| gain over keys:-0.5 | +0.0100 | +0.0200 | +0.0150 |\n"
            "| gain over best-spline | -0.0100 | -0.0100 | -0.0100 |\n");
}

TEST(EvalReport, JsonHasTheMeanAndTheParameters) {
  const auto json = ToJson(Report());
  EXPECT_DOUBLE_EQ(json["judged"]["mean"].get<double>(), 0.95);
  EXPECT_EQ(json["others"][1]["spline_k"][0], 0.0119);
  EXPECT_FALSE(json["others"][0].contains("keys_a"));
  EXPECT_EQ(json["protocols"][1]["offsets"], "pan");
}

}  // namespace
}  // namespace warplut
