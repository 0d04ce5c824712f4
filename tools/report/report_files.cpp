#include "tools/report/report_files.h"

#include <fmt/format.h>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/json_fields.h"
#include "tools/report/page/svg_plot.h"
#include "tools/tables/record_table.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

Json ToJson(const ReportPlot& plot) {
  Json series = Json::array();
  for (const PlotSeries& one : plot.series) {
    Json entry = {{"name", one.name}, {"x", one.x}, {"y", one.y}};
    if (!one.low.empty()) entry["low"] = one.low;
    if (!one.high.empty()) entry["high"] = one.high;
    if (!one.labels.empty()) entry["labels"] = one.labels;
    series.push_back(std::move(entry));
  }
  return {{"id", plot.id},
          {"caption", plot.caption},
          {"x", plot.x_label},
          {"y", plot.y_label},
          {"series", series}};
}

Json ToJson(const ReportSection& section) {
  Json plots = Json::array(), tables = Json::array(), pictures = Json::array();
  for (const ReportPlot& plot : section.plots) plots.push_back(ToJson(plot));
  for (const ReportTable& table : section.tables) {
    tables.push_back({{"id", table.id},
                      {"caption", table.caption},
                      {"header", table.table.header},
                      {"rows", table.table.rows}});
  }
  for (const ReportPicture& picture : section.pictures) {
    pictures.push_back(
        {{"caption", picture.caption}, {"left", picture.left_name}, {"right", picture.right_name}});
  }
  return {{"id", section.id},
          {"title", section.title},
          {"paragraphs", section.paragraphs},
          {"plots", plots},
          {"tables", tables},
          {"pictures", pictures},
          {"failures", section.failures},
          {"command", section.command}};
}

class ReportWriter {
 public:
  ReportWriter(const fs::path& folder, const std::function<void()>& on_file)
      : folder_(folder), on_file_(on_file) {
    for (const char* part : {"tables", "plots", "pictures"}) CreateFolder(folder / part);
  }

  void AddMedia(ReportSection& section) {
    for (const ReportPlot& plot : section.plots) {
      on_file_();
      try {
        const PlotFiles files{.wide = SvgPlot(plot, PlotShape::kWide),
                              .narrow = SvgPlot(plot, PlotShape::kNarrow)};
        WriteFile(folder_ / "plots" / (plot.id + ".svg"), files.wide);
        media_.plots.emplace(plot.id, files);
      } catch (const Error& failure) {
        section.failures.emplace_back(failure.what());
      }
    }
    for (const ReportTable& table : section.tables) {
      WriteFile(folder_ / "tables" / (table.id + ".md"), ToMarkdown(table.table));
    }
    std::vector<PictureFiles>& pictures = media_.pictures[section.id];
    for (const ReportPicture& picture : section.pictures) {
      on_file_();
      const std::string name = fmt::format("{}-{:02}", section.id, pictures.size());
      pictures.push_back(
          {.left = Png(name + "-left", picture.left),
           .right = picture.right.empty() ? "" : Png(name + "-right", picture.right)});
    }
  }

  void Finish(const PageHead& head, const std::vector<ReportSection>& sections) const {
    Json all = Json::array();
    for (const ReportSection& section : sections) all.push_back(ToJson(section));
    const std::string page = ReportPage(head, sections, media_);
    const Json document = {{"title", head.title}, {"about", head.paragraphs}, {"sections", all}};
    WriteFile(folder_ / "report.json", JsonText(document, 1) + "\n");
    WriteFile(folder_ / "index.html", page);
  }

 private:
  std::string Png(const std::string& name, const Image& image) const {
    const fs::path path = folder_ / "pictures" / (name + ".png");
    WriteImage(path, image, PixelType::kUint8);
    return ReadFile(path);
  }

  const fs::path folder_;
  const std::function<void()>& on_file_;
  PageMedia media_;
};

}  // namespace

void WriteReport(const fs::path& folder, const PageHead& head, std::vector<ReportSection> sections,
                 const std::function<void()>& on_file) {
  ReportWriter writer(folder, on_file);
  for (ReportSection& section : sections) writer.AddMedia(section);
  on_file();
  writer.Finish(head, sections);
}

}  // namespace warplut
