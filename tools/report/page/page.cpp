#include "tools/report/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "datasets/error.h"
#include "tools/report/page/embedded.h"
#include "tools/report/page/html.h"

namespace warplut {
namespace {

constexpr const char* kFailuresId = "failures";
constexpr const char* kFailuresTitle = "What failed or was left out, and why";
// Tables of more rows are folded.
constexpr std::size_t kUnfoldedRows = 32;
// Cells of more letters are words: aligned left, and broken into lines.
constexpr std::size_t kWordsLength = 28;

std::string Paragraphs(const std::vector<std::string>& paragraphs) {
  std::string html;
  for (const std::string& text : paragraphs) html += Element("p", {}, EscapeHtml(text)) + "\n";
  return html;
}

std::string List(const std::vector<std::string>& sentences) {
  std::string items;
  for (const std::string& text : sentences) items += Element("li", {}, EscapeHtml(text));
  return Element("ul", {}, items);
}

std::string PlotHtml(const ReportPlot& plot, const PlotFiles& files) {
  const std::string narrow = DataUri("image/svg+xml", files.narrow);
  const std::string wide = DataUri("image/svg+xml", files.wide);
  std::string alt =
      fmt::format("Plot: {}. {} against {}.", plot.caption, plot.y_label, plot.x_label);
  for (const PlotSeries& one : plot.series)
    alt += fmt::format(" {}: {} points.", one.name, one.x.size());
  return Element(
             "figure", {{"id", "plot-" + plot.id}, {"class", "plot"}},
             Element("picture", {},
                     VoidElement("source", {{"media", "(max-width: 600px)"}, {"srcset", narrow}}) +
                         VoidElement("img", {{"src", wide}, {"alt", alt}})) +
                 Element("figcaption", {}, EscapeHtml(plot.caption))) +
         "\n";
}

// Cells that begin as a number does, and those that stand for one that is not there.
bool IsNumber(const std::string& cell) {
  if (cell.empty() || cell == "-" || cell == "equal") return true;
  const std::size_t sign = cell[0] == '-' || cell[0] == '+' || cell[0] == '.' ? 1 : 0;
  return sign < cell.size() && std::isdigit(static_cast<unsigned char>(cell[sign])) != 0;
}

// "number" (aligned right), "name", or "words" (broken into lines), by what the column holds.
const char* ColumnClass(const TextTable& table, std::size_t column) {
  bool numbers = true;
  std::size_t longest = 0;
  for (const std::vector<std::string>& row : table.rows) {
    if (column >= row.size()) continue;
    numbers = numbers && IsNumber(row[column]);
    longest = std::max(longest, row[column].size());
  }
  if (column > 0 && longest > kWordsLength) return "words";
  return numbers && column > 0 ? "number" : "name";
}

std::string TableHtml(const ReportTable& table) {
  std::string head, body;
  std::vector<const char*> classes;
  for (std::size_t c = 0; c < table.table.header.size(); ++c) {
    classes.push_back(ColumnClass(table.table, c));
    head += Element("th", {{"scope", "col"}, {"class", classes.back()}},
                    Element("button", {{"type", "button"}}, EscapeHtml(table.table.header[c])));
  }
  for (const std::vector<std::string>& row : table.table.rows) {
    std::string cells;
    for (std::size_t c = 0; c < classes.size(); ++c) {
      cells += Element("td", {{"class", classes[c]}}, EscapeHtml(c < row.size() ? row[c] : ""));
    }
    body += Element("tr", {}, cells) + "\n";
  }
  const bool folded = table.table.rows.size() > kUnfoldedRows;
  const std::string caption = EscapeHtml(table.caption);
  const std::string html = Element(
      "div", {{"class", "scroll"}, {"id", "table-" + table.id}},
      Element("table", {},
              (folded ? std::string() : Element("caption", {}, caption)) +
                  Element("thead", {}, Element("tr", {}, head)) + Element("tbody", {}, body)));
  if (!folded) return html + "\n";
  return Element(
             "details", {},
             Element("summary", {}, fmt::format("{} ({} rows)", caption, table.table.rows.size())) +
                 html) +
         "\n";
}

std::string PictureHtml(const ReportPicture& picture, const PictureFiles& files) {
  const auto image = [](const std::string& png, const std::string& alt, const char* place) {
    return VoidElement("img", {{"class", place}, {"src", DataUri("image/png", png)}, {"alt", alt}});
  };
  const std::string caption = Element("figcaption", {}, EscapeHtml(picture.caption));
  if (files.right.empty()) {
    return Element(
        "figure", {},
        image(files.left, picture.caption + ": " + picture.left_name, "single") + caption);
  }
  const std::string stack =
      Element("div", {{"class", "stack"}},
              image(files.left, picture.caption + ": " + picture.left_name, "under") +
                  image(files.right, picture.caption + ": " + picture.right_name, "over"));
  const std::string label =
      fmt::format("border between {} and {}", picture.left_name, picture.right_name);
  const std::string slider = VoidElement(
      "input",
      {{"type", "range"}, {"min", "0"}, {"max", "100"}, {"value", "50"}, {"aria-label", label}});
  const std::string sides = Element("div", {{"class", "sides"}},
                                    Element("span", {}, EscapeHtml(picture.left_name)) +
                                        Element("span", {}, EscapeHtml(picture.right_name)));
  return Element("figure", {{"class", "pair"}}, stack + slider + sides + caption) + "\n";
}

std::string SectionHtml(const ReportSection& section, const PageMedia& media) {
  std::string html = Element("h2", {}, EscapeHtml(section.title)) + "\n";
  html += Paragraphs(section.paragraphs);
  for (const ReportPlot& plot : section.plots) {
    const auto files = media.plots.find(plot.id);
    if (files != media.plots.end()) html += PlotHtml(plot, files->second);
  }
  for (const ReportTable& table : section.tables) html += TableHtml(table);
  const auto pictures = media.pictures.find(section.id);
  if (pictures != media.pictures.end() && !pictures->second.empty()) {
    std::string figures;
    for (std::size_t i = 0; i < section.pictures.size(); ++i) {
      figures += PictureHtml(section.pictures[i], pictures->second[i]);
    }
    html += Element("div", {{"class", "pictures"}}, figures) + "\n";
  }
  if (!section.failures.empty()) {
    html += Element("div", {{"class", "failures"}},
                    Element("p", {}, "Failed, left out or missed") + List(section.failures));
  }
  if (!section.command.empty()) {
    html += Element("p", {}, "These numbers come from:") +
            Element("pre", {}, Element("code", {}, EscapeHtml(section.command)));
  }
  return Element("section", {{"id", section.id}}, html) + "\n";
}

std::string FailuresHtml(const std::vector<ReportSection>& sections) {
  std::string html = Element("h2", {}, kFailuresTitle);
  bool any = false;
  for (const ReportSection& section : sections) {
    if (section.failures.empty()) continue;
    any = true;
    html += Element("h3", {}, EscapeHtml(section.title)) + List(section.failures);
  }
  if (!any) html += Element("p", {}, "Nothing.");
  return Element("section", {{"id", kFailuresId}}, html) + "\n";
}

void RequireUniqueIds(const std::vector<ReportSection>& sections) {
  std::set<std::string> ids = {kFailuresId};
  const auto add = [&](const std::string& id) {
    if (!ids.insert(id).second) throw Error("the report has two parts with the id '" + id + "'");
  };
  for (const ReportSection& section : sections) {
    add(section.id);
    for (const ReportPlot& plot : section.plots) add("plot-" + plot.id);
    for (const ReportTable& table : section.tables) add("table-" + table.id);
  }
}

std::string Contents(const std::vector<ReportSection>& sections) {
  std::string items;
  for (const ReportSection& section : sections) {
    items +=
        Element("li", {}, Element("a", {{"href", "#" + section.id}}, EscapeHtml(section.title)));
  }
  items +=
      Element("li", {}, Element("a", {{"href", std::string("#") + kFailuresId}}, kFailuresTitle));
  return Element("nav", {{"aria-label", "Contents"}}, Element("ol", {}, items)) + "\n";
}

}  // namespace

std::string ReportPage(const PageHead& head, const std::vector<ReportSection>& sections,
                       const PageMedia& media) {
  RequireUniqueIds(sections);
  std::string body;
  for (const ReportSection& section : sections) body += SectionHtml(section, media);
  body += FailuresHtml(sections);
  return "<!doctype html>\n" +
         Element(
             "html", {{"lang", "en"}},
             Element("head", {},
                     VoidElement("meta", {{"charset", "utf-8"}}) +
                         VoidElement("meta", {{"name", "viewport"},
                                              {"content", "width=device-width, initial-scale=1"}}) +
                         Element("title", {}, EscapeHtml(head.title)) +
                         Element("style", {}, embedded::kPageStyle)) +
                 "\n" +
                 Element("body", {},
                         Element("header", {},
                                 Element("h1", {}, EscapeHtml(head.title)) +
                                     Paragraphs(head.paragraphs)) +
                             Contents(sections) + Element("main", {}, body) +
                             Element("script", {}, embedded::kPageScript))) +
         "\n";
}

}  // namespace warplut
