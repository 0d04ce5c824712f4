// Plots as SVG, drawn by gnuplot.
#pragma once

#include <string>

#include "tools/report/report_section.h"

namespace warplut {

// kWide is for documents and large screens, kNarrow for phones: fewer pixels, the same size of the
// letters.
enum class PlotShape : std::uint8_t { kWide, kNarrow };

// Throws an Error that names the missing package unless gnuplot can be run.
void RequireGnuplot();

// The plot as an SVG file that refers to nothing outside. Series differ by colour and by mark;
// lines, letters and grid follow the light or dark scheme of the reader. Labels for which there is
// no room are left out. An Error names the plot if gnuplot refuses it.
std::string SvgPlot(const ReportPlot& plot, PlotShape shape);

}  // namespace warplut
