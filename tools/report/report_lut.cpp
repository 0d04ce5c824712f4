#include "tools/report/report_lut.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "datasets/file.h"
#include "luts/bake/table_io.h"
#include "tools/report/page/embedded.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

ReportLut LoadShipped(const std::filesystem::path& folder, std::string_view text) {
  const std::string name = nlohmann::json::parse(text).at("name");
  const std::filesystem::path path = folder / (name + ".json");
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) WriteFile(path, text);
  ranks.Meet();
  return LoadReportLut(path);
}

}  // namespace

ReportLut LoadReportLut(const std::filesystem::path& path) {
  LoadedTable loaded = LoadTable(path);
  ReportLut lut;
  lut.name = loaded.name;
  lut.scale = loaded.scale;
  if (IsFit(path)) lut.fit = ReadFit(path);
  lut.baked = std::make_unique<const BakedTable>(std::move(loaded.table));
  lut.table = std::make_unique<const Table>(lut.baked->view());
  return lut;
}

ReportLut ShippedWarpLut(const std::filesystem::path& folder) {
  return LoadShipped(folder, embedded::kWarpFit);
}

ReportLut ShippedPipelineLut(const std::filesystem::path& folder) {
  return LoadShipped(folder, embedded::kPipelineFit);
}

}  // namespace warplut
