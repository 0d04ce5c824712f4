// The page of a report: escaping, well-formedness, nothing from elsewhere; and the plots in it.
#include "tools/report/page/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "datasets/error.h"
#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tools/report/page/html.h"
#include "tools/report/page/svg_plot.h"
#include "tools/report/report_files.h"

namespace warplut {
namespace {

using testing::HasSubstr;
using testing::Not;

// A section with everything that a section can have, and letters that HTML gives a meaning.
ReportSection FullSection() {
  ReportSection section{.id = "sample", .title = "Sample <& co>"};
  section.paragraphs = {"1 < 2 && \"quoted\""};
  section.plots = {
      {.id = "sample-plot",
       .caption = "time & 'error'",
       .x_label = "ms",
       .y_label = "1 - SSIM",
       .logarithmic_x = true,
       .logarithmic_y = true,
       .series = {
           {.name = "a_b's", .x = {1, 10, 0}, .y = {1e-3, 1e-2, 1}, .labels = {"p", "<q>", "r"}},
           {.name = "bars",
            .x = {2, 3},
            .y = {1e-2, 2e-2},
            .low = {5e-3, 1e-2},
            .high = {2e-2, 4e-2},
            .line = true}}}};
  section.tables = {
      {.id = "sample-table",
       .caption = "a <table>",
       .table = {.header = {"name", "value"}, .rows = {{"<script>", "1"}, {"short"}}}}};
  Image picture(4, 3, 3);
  section.pictures = {
      {.caption = "c", .left_name = "l", .right_name = "r", .left = picture, .right = picture},
      {.caption = "one", .left_name = "l", .right_name = "", .left = picture, .right = {}}};
  section.failures = {"nothing <worked>"};
  section.command = "warplut report --out 'x & y'";
  return section;
}

// Every element that begins ends, in order. What stands in style and script is text.
void ExpectBalanced(const std::string& html) {
  static const std::set<std::string> kVoid = {"meta", "img", "input", "source"};
  std::vector<std::string> open;
  std::size_t position = html.find('\n') + 1;  // behind the doctype
  for (position = html.find('<', position); position != std::string::npos;
       position = html.find('<', position)) {
    const std::size_t end = html.find('>', position);
    ASSERT_NE(end, std::string::npos);
    std::string name = html.substr(position + 1, end - position - 1);
    position = end + 1;
    const bool ends = name.front() == '/';
    if (ends) name.erase(0, 1);
    name = name.substr(0, name.find(' '));
    if (kVoid.contains(name)) continue;
    if (!ends) {
      open.push_back(name);
      if (name == "style" || name == "script") position = html.find("</" + name, position);
      continue;
    }
    ASSERT_FALSE(open.empty()) << name;
    ASSERT_EQ(open.back(), name);
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
}

TEST(Html, EscapesWhatHasAMeaning) {
  EXPECT_EQ(EscapeHtml("<a href=\"x\">'&amp;'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(EscapeHtml(std::string("a\0b\x01\n\tc", 7)), "ab\n\tc");
  EXPECT_EQ(EscapeHtml("\xC2\xB5m"), "\xC2\xB5m");
  EXPECT_EQ(Element("p", {{"title", "\"<"}}, "&lt;"), "<p title=\"&quot;&lt;\">&lt;</p>");
}

TEST(Html, DataUrisAreBase64) {
  EXPECT_EQ(DataUri("text/plain", ""), "data:text/plain;base64,");
  EXPECT_EQ(DataUri("text/plain", "f"), "data:text/plain;base64,Zg==");
  EXPECT_EQ(DataUri("text/plain", "fo"), "data:text/plain;base64,Zm8=");
  EXPECT_EQ(DataUri("text/plain", "foobar"), "data:text/plain;base64,Zm9vYmFy");
}

class ReportOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    WriteReport(folder_ / "", {.title = "A & B", .paragraphs = {"made <now>"}}, {FullSection()},
                [] {});
  }
  const TemporaryFolder folder_;
};

TEST_F(ReportOnDisk, ThePageIsWellFormedAndStandsAlone) {
  const std::string page = ReadFile(folder_ / "index.html");
  ExpectBalanced(page);
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64,"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(page, HasSubstr("nothing &lt;worked&gt;"));
  EXPECT_THAT(page, HasSubstr("type=\"range\""));
  // Whatever is loaded is inside; links stay on the page.
  const std::regex reference("(src|srcset|href)=\"([^\"]{0,12})");
  for (std::sregex_iterator one(page.begin(), page.end(), reference), end; one != end; ++one) {
    EXPECT_TRUE((*one)[2].str().starts_with("data:") || (*one)[2].str().starts_with("#"))
        << one->str();
  }
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
}

TEST_F(ReportOnDisk, IdsAreUniqueAndImagesHaveTexts) {
  const std::string page = ReadFile(folder_ / "index.html");
  std::multiset<std::string> ids;
  const std::regex id(" id=\"([^\"]*)\"");
  for (std::sregex_iterator one(page.begin(), page.end(), id), end; one != end; ++one) {
    ids.insert((*one)[1].str());
  }
  for (const std::string& one : ids) EXPECT_EQ(ids.count(one), 1U) << one;
  EXPECT_TRUE(ids.contains("sample") && ids.contains("table-sample-table") &&
              ids.contains("failures"));
  std::size_t images = 0, texts = 0;
  for (std::size_t at = 0; (at = page.find("<img ", at)) != std::string::npos; ++at) ++images;
  for (std::size_t at = 0; (at = page.find(" alt=\"", at)) != std::string::npos; ++at) ++texts;
  EXPECT_EQ(images, texts);
}

TEST_F(ReportOnDisk, TablesPlotsAndNumbersAreFilesToo) {
  EXPECT_THAT(ReadFile(folder_ / "tables/sample-table.md"), HasSubstr("| <script> | 1 |"));
  EXPECT_THAT(ReadFile(folder_ / "plots/sample-plot.svg"), HasSubstr("</svg>"));
  const auto document = nlohmann::json::parse(ReadFile(folder_ / "report.json"));
  EXPECT_EQ(document["sections"][0]["plots"][0]["series"][0]["y"][1], 1e-2);
  EXPECT_EQ(document["sections"][0]["tables"][0]["rows"][0][0], "<script>");
}

TEST_F(ReportOnDisk, WhatIsThrownLeavesTheOldPage) {
  const std::string before = ReadFile(folder_ / "index.html");
  int files = 0;
  EXPECT_THROW(WriteReport(folder_ / "", {.title = "New", .paragraphs = {}}, {FullSection()},
                           [&] {
                             if (++files == 3) throw Error("stopped");
                           }),
               Error);
  EXPECT_EQ(ReadFile(folder_ / "index.html"), before);
}

TEST(Page, RefusesTwoPartsOfOneId) {
  ReportSection twice = FullSection();
  twice.tables.push_back(twice.tables.front());
  EXPECT_THROW(ReportPage({.title = "t", .paragraphs = {}}, {twice}, {}), Error);
  EXPECT_THROW(ReportPage({.title = "t", .paragraphs = {}}, {FullSection(), FullSection()}, {}),
               Error);
}

TEST(SvgPlot, DrawsPointsLabelsAndNames) {
  for (const PlotShape shape : {PlotShape::kWide, PlotShape::kNarrow}) {
    const std::string svg = SvgPlot(FullSection().plots.front(), shape);
    EXPECT_THAT(svg, HasSubstr("<title>time &amp; &#39;error&#39;</title>"));
    EXPECT_THAT(svg, HasSubstr("<text>&lt;q"));
    EXPECT_THAT(svg, HasSubstr("a_b"));
    EXPECT_THAT(svg, HasSubstr("1 - SSIM"));
    EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
  }
}

TEST(SvgPlot, DrawsWithoutASinglePoint) {
  ReportPlot plot = FullSection().plots.front();
  for (PlotSeries& one : plot.series) one.x = one.y = one.low = one.high = {}, one.labels = {};
  EXPECT_THAT(SvgPlot(plot, PlotShape::kWide), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace warplut
