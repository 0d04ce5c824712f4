#include "tools/report/page/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "datasets/error.h"
#include "tools/report/page/html.h"
#include "tools/report/page/label_placement.h"
#include "tools/report/page/plot_axis.h"
#include "tools/report/process.h"

namespace warplut {
namespace {

// Okabe and Ito 2008: told apart with any colour vision, on white and on black; their yellow and
// black are left out.
constexpr std::array<const char*, 6> kColors = {"#0072B2", "#D55E00", "#009E73",
                                                "#CC79A7", "#E69F00", "#56B4E9"};
// gnuplot's marks: filled and open circle, square, triangles and diamond.
constexpr std::array<int, 8> kMarks = {7, 5, 9, 13, 11, 6, 4, 8};

// Colours that stand for those of the reader's scheme.
constexpr const char* kInk = "#123456";
constexpr const char* kGrid = "#123457";
constexpr std::string_view kStyle = R"css(<style>
[fill="rgb(18,52,86)"]{fill:#222}
[stroke="rgb( 18,  52,  86)"]{stroke:#555}
[stroke="rgb( 18,  52,  87)"]{stroke:#ddd}
@media (prefers-color-scheme:dark){
[fill="rgb(18,52,86)"]{fill:#e4e4e4}
[stroke="rgb( 18,  52,  86)"]{stroke:#aaa}
[stroke="rgb( 18,  52,  87)"]{stroke:#444}
}
</style>
)css";

constexpr double kLetter = 13;         // pixels of the font
constexpr double kLetterWidth = 0.56;  // mean width of a letter, as a share of its size
constexpr double kLabelLetter = 11;    // of labels at points
constexpr double kKeyLine = 19;        // pixels from name to name
constexpr double kTop = 14, kLeft = 74, kBottom = 62;

double TextWidth(const std::string& text, double letter) {
  return kLetterWidth * letter * static_cast<double>(text.size());
}

// A gnuplot string: single quotes, in which a quote is doubled and nothing else is special.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += c;
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "'";
}

// Places in pixels: the plot's frame inside the picture, and the key beside or below it.
struct Layout {
  double width, height;
  LabelBox frame;
  double key_left, key_top;  // of the first name
};

Layout LayOut(const ReportPlot& plot, PlotShape shape) {
  std::size_t longest = 0;
  for (const PlotSeries& one : plot.series) longest = std::max(longest, one.name.size());
  const double key_width =
      plot.series.size() < 2 ? 0 : 44 + TextWidth(std::string(longest, 'x'), kLetter);
  const double key_height =
      plot.series.size() < 2 ? 0 : kKeyLine * static_cast<double>(plot.series.size()) + 10;
  if (shape == PlotShape::kWide) {
    Layout layout{.width = 860,
                  .height = std::max(430.0, key_height + 2 * kTop),
                  .frame = {},
                  .key_left = 0,
                  .key_top = kTop};
    layout.frame = {kLeft, kTop, layout.width - key_width - 16, layout.height - kBottom};
    layout.key_left = layout.frame.right + 8;
    return layout;
  }
  Layout layout{.width = 380, .height = 330 + key_height, .frame = {}, .key_left = 8, .key_top = 0};
  layout.frame = {kLeft - 12, kTop, layout.width - 14, layout.height - key_height - kBottom};
  layout.key_top = layout.frame.bottom + kBottom;
  return layout;
}

std::vector<double> Values(const ReportPlot& plot, bool y) {
  std::vector<double> values;
  for (const PlotSeries& one : plot.series) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      values.push_back(y ? one.y[i] : one.x[i]);
      if (y && !one.low.empty()) values.push_back(one.low[i]);
      if (y && !one.high.empty()) values.push_back(one.high[i]);
    }
  }
  return values;
}

std::string AxisCommands(char name, const PlotAxis& axis, int most) {
  std::string tics;
  for (const double tic : axis.Tics(most)) {
    tics += fmt::format("{}{} {:.10g}", tics.empty() ? "" : ", ", Quoted(TicText(tic)), tic);
  }
  return fmt::format(
      "set {0}range [{1:.10g}:{2:.10g}]\n{3}set {0}tics nomirror scale 0.5,0 textcolor rgb '{4}' "
      "({5})\n",
      name, axis.low(), axis.high(),
      axis.logarithmic() ? fmt::format("set logscale {}\n", name) : std::string(), kInk, tics);
}

class PlotScript {
 public:
  PlotScript(const ReportPlot& plot, PlotShape shape)
      : plot_(plot),
        layout_(LayOut(plot, shape)),
        x_(plot.logarithmic_x, Values(plot, false)),
        y_(plot.logarithmic_y, Values(plot, true)) {
    const bool wide = shape == PlotShape::kWide;
    script_ = fmt::format(
        "set terminal svg size {},{} noenhanced font 'sans-serif,{}' rounded\nset encoding utf8\n"
        "set pointintervalbox 0\n"
        "set border 3 linecolor rgb '{}'\nset grid linecolor rgb '{}' linewidth 0.7 dashtype 1\n",
        layout_.width, layout_.height, kLetter, kInk, kGrid);
    script_ += AxisCommands('x', x_, wide ? 9 : 5);
    script_ += AxisCommands('y', y_, 8);
    AddMargins();
    AddAxisNames();
    AddLabels();
    AddSeries();
  }

  const std::string& text() const { return script_; }

 private:
  bool CanDraw(const PlotSeries& one, std::size_t i) const {
    return x_.CanDraw(one.x[i]) && y_.CanDraw(one.y[i]);
  }

  void AddMargins() {
    const LabelBox& frame = layout_.frame;
    script_ += fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
        "set bmargin at screen {:.5f}\n",
        frame.left / layout_.width, frame.right / layout_.width, 1 - frame.top / layout_.height,
        1 - frame.bottom / layout_.height);
    script_ +=
        plot_.series.size() < 2
            ? "unset key\n"
            : fmt::format(
                  "set key at screen {:.5f},{:.5f} left top Left reverse samplen 1.2 "
                  "spacing 1.1 textcolor rgb '{}'\n",
                  layout_.key_left / layout_.width, 1 - layout_.key_top / layout_.height, kInk);
  }

  // Centred below the frame, and at the left edge of the picture.
  void AddAxisNames() {
    const LabelBox& frame = layout_.frame;
    script_ += fmt::format("set xlabel {} textcolor rgb '{}'\n", Quoted(plot_.x_label), kInk);
    script_ +=
        fmt::format("set label {} at screen {:.5f},{:.5f} center rotate by 90 textcolor rgb '{}'\n",
                    Quoted(plot_.y_label), kLetter / layout_.width,
                    1 - (frame.top + frame.bottom) / 2 / layout_.height, kInk);
  }

  void AddLabels() {
    std::vector<LabelledPoint> points;
    std::vector<std::string> texts;
    const LabelBox& frame = layout_.frame;
    for (const PlotSeries& one : plot_.series) {
      for (std::size_t i = 0; i < one.x.size(); ++i) {
        if (!CanDraw(one, i)) continue;
        const std::string text = one.labels.empty() ? "" : one.labels[i];
        points.push_back({.x = frame.left + x_.Share(one.x[i]) * (frame.right - frame.left),
                          .y = frame.bottom - y_.Share(one.y[i]) * (frame.bottom - frame.top),
                          .width = TextWidth(text, kLabelLetter),
                          .height = kLabelLetter + 1});
        texts.push_back(text);
      }
    }
    const std::vector<PlacedLabel> placed = PlaceLabels(points, frame);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (!placed[i].shown) continue;
      const LabelBox& box = placed[i].box;
      script_ += fmt::format(
          "set label {} at screen {:.5f},{:.5f} center front font ',{}' textcolor rgb '{}'\n",
          Quoted(texts[i]), (box.left + box.right) / 2 / layout_.width,
          1 - (box.top + box.bottom) / 2 / layout_.height, kLabelLetter, kInk);
    }
  }

  void AddSeries() {
    std::string plots;
    for (std::size_t s = 0; s < plot_.series.size(); ++s) {
      const PlotSeries& one = plot_.series[s];
      const bool bars = !one.low.empty() && !one.high.empty();
      std::string data;
      for (std::size_t i = 0; i < one.x.size(); ++i) {
        if (!CanDraw(one, i)) continue;
        data += fmt::format("{:.10g} {:.10g}", one.x[i], one.y[i]);
        if (bars) {
          data += fmt::format(" {:.10g} {:.10g}", y_.CanDraw(one.low[i]) ? one.low[i] : one.y[i],
                              y_.CanDraw(one.high[i]) ? one.high[i] : one.y[i]);
        }
        data += '\n';
      }
      if (data.empty()) data = "NaN NaN NaN NaN\n";
      script_ += fmt::format("$series{} << END_OF_SERIES\n{}END_OF_SERIES\n", s, data);
      const std::string look = fmt::format("linecolor rgb '{}'", kColors[s % kColors.size()]);
      const std::string mark = fmt::format("pointtype {} pointsize 0.6", kMarks[s % kMarks.size()]);
      if (bars) {
        plots += fmt::format("{}$series{} using 1:2:3:4 with yerrorbars {} {} notitle",
                             plots.empty() ? "" : ", ", s, look, mark);
      }
      plots += fmt::format(
          "{}$series{} using 1:2 with {} {} {} title {}", plots.empty() ? "" : ", ", s,
          one.line ? "linespoints linewidth 1.6" : "points", look, mark, Quoted(one.name));
    }
    script_ += "plot " + plots + "\n";
  }

  const ReportPlot& plot_;
  const Layout layout_;
  const PlotAxis x_, y_;
  std::string script_;
};

// Puts the caption and the reader's scheme in the place of gnuplot's own title.
std::string WithStyle(std::string svg, const std::string& caption) {
  const auto title = svg.find("<title>");
  constexpr std::string_view kEnd = "</desc>\n";
  const auto end = svg.find(kEnd);
  if (title == std::string::npos || end == std::string::npos) {
    throw Error("gnuplot gave something else than the expected SVG");
  }
  return svg.replace(title, end + kEnd.size() - title,
                     Element("title", {}, EscapeHtml(caption)) + "\n" + std::string(kStyle));
}

}  // namespace

void RequireGnuplot() {
  const ProcessResult result = RunProcess({"gnuplot", "--version"}, "");
  if (!result.found) {
    throw Error("gnuplot was not found, which draws the plots; install the package gnuplot-nox");
  }
}

std::string SvgPlot(const ReportPlot& plot, PlotShape shape) {
  const ProcessResult drawn = RunProcess({"gnuplot"}, PlotScript(plot, shape).text());
  if (!drawn.found || drawn.code != 0 || drawn.out.find("</svg>") == std::string::npos) {
    throw Error(fmt::format("gnuplot could not draw '{}': {}", plot.id,
                            drawn.found ? drawn.err : "it was not found"));
  }
  return WithStyle(drawn.out, plot.caption);
}

}  // namespace warplut
