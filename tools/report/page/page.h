// Sections of a report as one HTML page that needs no other file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/report/report_section.h"

namespace warplut {

// What is drawn or encoded before the page is put together: of a plot by its id its SVG of both
// shapes; of a picture its PNG files, in the order of the section's pictures (right is empty where
// the picture has none).
struct PlotFiles {
  std::string wide, narrow;
};
struct PictureFiles {
  std::string left, right;
};
struct PageMedia {
  std::map<std::string, PlotFiles> plots;
  std::map<std::string, std::vector<PictureFiles>> pictures;  // by the id of the section
};

struct PageHead {
  std::string title;
  std::vector<std::string> paragraphs;  // of what, when, how long
};

// The page: a table of contents, then the sections, and last "What failed or was left out", all
// failures of all sections. Plots and pictures are inside as data; letters and colours follow the
// reader's light or dark scheme; tables can be sorted; everything is readable without scripts.
// Every id of sections, tables and plots occurs once: else an Error names it.
std::string ReportPage(const PageHead& head, const std::vector<ReportSection>& sections,
                       const PageMedia& media);

}  // namespace warplut
