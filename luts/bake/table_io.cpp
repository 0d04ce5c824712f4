#include "luts/bake/table_io.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "luts/bake/released_layout.h"
#include "luts/fit/fit.h"
#include "luts/fit/json_header.h"
#include "luts/fit/prefilter_json.h"
#include "luts/quantize/quantize.h"

namespace warplut {
namespace {

constexpr std::array<std::pair<TableFormat, const char*>, 4> kStorages = {
    {{TableFormat::kI16, Name(TableFormat::kI16)},
     {TableFormat::kF16, Name(TableFormat::kF16)},
     {TableFormat::kI8, Name(TableFormat::kI8)},
     {TableFormat::kF32, Name(TableFormat::kF32)}}};

std::string Quoted(const std::string& file) { return "'" + file + "'"; }

void ExpectInteger(JsonFields& fields, const char* name, int expected) {
  const int found = fields.Integer(name);
  if (found != expected) fields.At(name).Fail(fmt::format("is {}; expected {}", found, expected));
}

LoadedTable FromTableJson(JsonFields fields, const std::string& file) {
  const int version = CheckHeader(fields, kTableFormat, 1, kTableVersion);
  const Footprint footprint = version > 1 ? ReadFootprint(fields) : Footprint::k16;
  const FootprintTaps& taps = TapsOf(footprint);
  // Version 2 has taps, a prefilter or both: both is one too many, which CheckTable says.
  const bool prefiltered = version > 1 && (footprint == Footprint::k16 || fields.Has("prefilter"));
  const Prefilter prefilter = prefiltered ? ReadPrefilter(fields.Object("prefilter")) : Prefilter{};
  std::string name = fields.Text("name");
  const double scale = fields.Number("scale");
  if (scale < 1) fields.At("scale").Fail(fmt::format("is {}; expected at least 1", scale));
  ExpectInteger(fields, "nodes", kNodes);
  const TableFormat format = fields.OneOf("storage", kStorages);
  ExpectInteger(fields, "fraction_bits", FractionBits(format));
  // What made the table and what it promises is for people; both follow from the values and the
  // fit.
  fields.Object("provenance");
  fields.Object("certificate");
  const JsonPlace place = fields.At("values");
  const nlohmann::json& values =
      place.Array(fields.Take("values"), static_cast<std::size_t>(TableValues(footprint)));
  std::vector<IntegerRow> rows(kRows);
  std::size_t i = 0;
  for (IntegerRow& row : rows) {
    for (const int k : taps) {
      const JsonPlace element = place.Element(i);
      row[k] = element.Integer(values[i++]);
      if (!CanStore(format, row[k])) {
        element.Fail(fmt::format("is {}, which {} cannot store; expected a weight in [-2, 2)",
                                 row[k], Name(format)));
      }
    }
  }
  fields.Finish();
  BakedTable table(format, rows, prefilter, footprint);
  CheckTable(table.view(), Quoted(file));
  return {std::move(name), std::move(table), scale};
}

LoadedTable FromJson(const std::filesystem::path& path, TableFormat format) {
  const nlohmann::json json = ReadJson(path);
  const std::string file = path.string();
  JsonFields fields(json, JsonPlace(file, ""));
  const std::string kind = fields.Text("format");
  if (kind == kTableFormat) return FromTableJson(JsonFields(json, JsonPlace(file, "")), file);
  if (kind != kFitFormat) {
    fields.At("format").Fail(
        fmt::format("is \"{}\"; expected \"{}\" or \"{}\"", kind, kFitFormat, kTableFormat));
  }
  const Fit fit = ReadFit(path);
  RealTable real = SampleFit(fit, kNodes);
  real.name = Quoted(file);
  return {fit.name, Quantize(real, format), fit.scale};
}

}  // namespace

bool IsFit(const std::filesystem::path& path) {
  if (!HasExtension(path, ".json")) return false;
  const nlohmann::json json = ReadJson(path);
  return json.is_object() && json.contains("format") && json["format"] == kFitFormat;
}

LoadedTable LoadTable(const std::filesystem::path& path, TableFormat format) {
  if (HasExtension(path, ".json")) return FromJson(path, format);
  if (!HasExtension(path, ".exr")) {
    throw Error(fmt::format(
        "'{}' is no table: expected a fit or baked table (.json), or an image in the released "
        "layout (.exr)",
        path.string()));
  }
  const RealTable released = FromReleasedLayout(ReadImage(path), Quoted(path.string()));
  return {path.stem().string(), Quantize(Resample(released, kNodes), format), std::nullopt};
}

}  // namespace warplut
