// What a section of the report is made of; tools/report/page/page.h turns sections into one page.
#pragma once

#include <string>
#include <vector>

#include "datasets/image.h"
#include "tools/tables/table_text.h"

namespace warplut {

struct ReportTable {
  std::string id;  // of its markers in the documents, unique in the report: lower case and hyphens
  std::string caption;
  TextTable table;
};

// One series of points. `labels`, if not empty, name the points one by one; `low` and `high`, if
// not empty, are error bars in y.
struct PlotSeries {
  std::string name;
  std::vector<double> x = {}, y = {};
  std::vector<double> low = {}, high = {};
  std::vector<std::string> labels = {};
  bool line = false;  // joins the points in their order
};

// Points that are not finite, or not positive on a logarithmic axis, are left out by the page.
struct ReportPlot {
  std::string id;  // as for tables
  std::string caption;
  std::string x_label, y_label;
  bool logarithmic_x = false, logarithmic_y = false;
  std::vector<PlotSeries> series;
};

// Two pictures of one size under a slider; `right` may be empty (one picture). Values in [0, 1] are
// shown as they are.
struct ReportPicture {
  std::string caption;
  std::string left_name, right_name;
  Image left, right;
};

// Shown in the order of the members.
struct ReportSection {
  std::string id;  // the anchor
  std::string title;
  std::vector<std::string> paragraphs = {};
  std::vector<ReportPlot> plots = {};
  std::vector<ReportTable> tables = {};
  std::vector<ReportPicture> pictures = {};
  std::vector<std::string> failures =
      {};  // what failed, was left out or missed its target, and why: one sentence each
  std::string command = {};  // that reproduces the numbers
};

}  // namespace warplut
