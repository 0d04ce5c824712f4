#include "tools/judge/sequence_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/datasets/expect_error.h"

namespace warplut {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

SequenceReport Report(double psnr) {
  SequenceScores sr;
  sr.method = "sr";
  sr.frames = {{.name = "0001", .mean_squared_error = 0, .psnr = psnr, .ssim = 0.9},
               {.name = "0002", .mean_squared_error = 0, .psnr = kInfinity, .ssim = 1}};
  sr.temporal = {kNan, 0.0125};
  sr.mean = {.name = "mean", .mean_squared_error = 0, .psnr = psnr, .ssim = 0.95};
  sr.temporal_error = 0.0125;
  sr.milliseconds = 12.34;
  SequenceScores still = sr;
  still.method = "repeat";
  still.temporal_error = kNan;
  still.milliseconds = 0;
  return {.sequence = "street", .methods = {sr, still}};
}

TEST(SequenceReport, TablesShowWhatThereIs) {
  EXPECT_EQ(ToMarkdown(MethodTable(Report(31.256))),
            "| street | PSNR dB | SSIM | temporal | ms/frame |\n|---|---:|---:|---:|---:|\n"
            "| sr | 31.26 | 0.9500 | 0.0125 | 12.3 |\n| repeat | 31.26 | 0.9500 | - | - |\n");
  EXPECT_EQ(ToMarkdown(FrameTable(Report(30).methods[0])),
            "| sr | PSNR dB | SSIM | temporal |\n|---|---:|---:|---:|\n"
            "| 0001 | 30.00 | 0.9000 | - |\n| 0002 | equal | 1.0000 | 0.0125 |\n"
            "| mean | 30.00 | 0.9500 | 0.0125 |\n");
}

TEST(SequenceReport, ErrorsOfTheJitterAreShownWhereAskedFor) {
  SequenceReport report = Report(31), other = Report(32);
  for (SequenceReport* one : {&report, &other}) {
    one->methods[0].jitter = {.repeating = 0.00125, .lattice = 0.0005};
    one->methods[1].jitter = {.repeating = kNan, .lattice = kNan};
  }
  other.methods[0].jitter->repeating = 0.00375;
  EXPECT_EQ(ToMarkdown(MethodTable(report)),
            "| street | PSNR dB | SSIM | temporal | jitter | lattice | ms/frame |\n"
            "|---|---:|---:|---:|---:|---:|---:|\n"
            "| sr | 31.00 | 0.9500 | 0.0125 | 0.00125 | 0.00050 | 12.3 |\n"
            "| repeat | 31.00 | 0.9500 | - | - | - | - |\n");
  const SequenceReport mean = MeanReport({report, other});
  EXPECT_DOUBLE_EQ(mean.methods[0].jitter->repeating, 0.0025);
  EXPECT_DOUBLE_EQ(mean.methods[0].jitter->lattice, 0.0005);
  const auto json = ToJson(report);
  EXPECT_EQ(json["methods"][0]["jitter_error"], 0.00125);
  EXPECT_TRUE(json["methods"][1]["lattice_error"].is_null());
  EXPECT_FALSE(ToJson(Report(31))["methods"][0].contains("jitter_error"));
}

SequenceReport SettledReport(double psnr) {
  SequenceReport report = Report(psnr);
  for (SequenceScores& scores : report.methods) {
    scores.settled = {
        .left_out = 1,
        .mean = {.name = "mean", .mean_squared_error = 0, .psnr = psnr + 1, .ssim = 0.96},
        .temporal_error = 0.01};
  }
  return report;
}

TEST(SequenceReport, BothMeansAreShown) {
  EXPECT_EQ(
      ToMarkdown(MethodTable(SettledReport(31))),
      "| street | PSNR dB | SSIM | temporal | without 1: PSNR dB | SSIM | temporal | ms/frame |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|\n"
      "| sr | 31.00 | 0.9500 | 0.0125 | 32.00 | 0.9600 | 0.0100 | 12.3 |\n"
      "| repeat | 31.00 | 0.9500 | - | 32.00 | 0.9600 | 0.0100 | - |\n");
  EXPECT_THAT(ToMarkdown(FrameTable(SettledReport(31).methods[0])),
              testing::HasSubstr("| mean | 31.00 | 0.9500 | 0.0125 |\n"
                                 "| mean without 1 | 32.00 | 0.9600 | 0.0100 |\n"));
  const SequenceReport mean = MeanReport({SettledReport(30), SettledReport(33)});
  ASSERT_TRUE(mean.methods[0].settled);
  EXPECT_EQ(mean.methods[0].settled->left_out, 1);
  EXPECT_DOUBLE_EQ(mean.methods[0].settled->mean.psnr, 32.5);
  EXPECT_DOUBLE_EQ(mean.methods[0].settled->temporal_error, 0.01);
  const auto json = ToJson(SettledReport(31));
  EXPECT_EQ(json["methods"][0]["psnr"], 31.0);
  EXPECT_EQ(json["methods"][0]["settled"]["left_out"], 1);
  EXPECT_EQ(json["methods"][0]["settled"]["psnr"], 32.0);
  EXPECT_EQ(json["methods"][0]["settled"]["ssim"], 0.96);
  EXPECT_EQ(json["methods"][0]["settled"]["temporal_error"], 0.01);
  EXPECT_FALSE(ToJson(Report(31))["methods"][0].contains("settled"));
}

TEST(SequenceReport, TheMeanIsOverSequences) {
  const SequenceReport mean = MeanReport({Report(30), Report(32)});
  EXPECT_EQ(mean.sequence, "mean");
  EXPECT_DOUBLE_EQ(mean.methods[0].mean.psnr, 31);
  EXPECT_DOUBLE_EQ(mean.methods[0].temporal_error, 0.0125);
  EXPECT_NEAR(mean.methods[0].milliseconds, 12.34, 1e-9);
}

TEST(SequenceReport, WhatIsEqualDoesNotCountInTheMeanOfThePsnr) {
  const SequenceReport mean = MeanReport({Report(30), Report(kInfinity), Report(32)});
  EXPECT_DOUBLE_EQ(mean.methods[0].mean.psnr, 31);
  EXPECT_DOUBLE_EQ(MeanReport({Report(kInfinity)}).methods[0].mean.psnr, kInfinity);
}

TEST(SequenceReport, JsonHasNullWhereThereIsNoNumber) {
  const auto json = ToJson(Report(30));
  EXPECT_EQ(json["sequence"], "street");
  EXPECT_EQ(json["methods"][0]["psnr"], 30.0);
  EXPECT_TRUE(json["methods"][0]["frames"][0]["temporal_error"].is_null());
  EXPECT_TRUE(json["methods"][0]["frames"][1]["psnr"].is_null());
  EXPECT_TRUE(json["methods"][1]["temporal_error"].is_null());
}

TEST(SequenceTarget, IsMissedWhereAScoreIsLess) {
  const SequenceTarget target = ParseSequenceTarget("sr,31,.95");
  EXPECT_EQ(target.method, "sr");
  EXPECT_EQ(target.psnr, 31);
  EXPECT_EQ(target.ssim, 0.95);
  const std::vector<SequenceReport> reports = {Report(30.9), Report(31)};
  ASSERT_EQ(MissedSequences(target, reports).size(), 1U);
  EXPECT_THAT(MissedSequences(target, reports)[0], testing::HasSubstr("30.90"));
  EXPECT_EQ(MissedSequences(ParseSequenceTarget("sr,-5,0.951"), reports).size(), 2U);
  EXPECT_TRUE(MissedSequences(ParseSequenceTarget("i,99,1"), reports).empty());
}

TEST(SequenceTarget, RefusesAnythingElse) {
  for (const char* text :
       {"", "sr", "sr,31", ",31,.9", "sr,x,.9", "sr,31,", "sr,31,.9,2", "sr,inf,1"}) {
    ExpectError([&] { ParseSequenceTarget(text); }, {"target", text, "METHOD,PSNR,SSIM"});
  }
}

}  // namespace
}  // namespace warplut
