#include "luts/bake/bake.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "datasets/error.h"
#include "datasets/file.h"
#include "luts/bake/baked_header.h"
#include "luts/bake/exr.h"
#include "luts/bake/released_layout.h"
#include "luts/bake/shader_source.h"
#include "luts/bake/table_texture.h"
#include "luts/bake/test_vectors.h"
#include "luts/fit/fit_records.h"
#include "luts/fit/json_header.h"
#include "luts/fit/prefilter_json.h"
#include "luts/quantize/quantize.h"

namespace warplut {
namespace {

nlohmann::ordered_json Provenance(const Fit& fit) {
  nlohmann::ordered_json json;
  json["fit"] = fit.name;
  json["objective"] = fit.objective;
  json["optimizer"] = fit.optimizer;
  json["seed"] = fit.seed;
  json["horizons"] = fit.horizons;
  json["gain_bound"] = fit.gain_bound;
  json["keys_a"] = fit.keys_a;
  json["options"] = fit.options;
  if (fit.cut) json["ended"] = kCutFit;
  json["data"] = fit.data;
  json["validation"] = fit.validation;
  return json;
}

// The values as the last field, one row a line.
std::string BakedJson(const Fit& fit, const TableView& table, const Certificate& certificate) {
  nlohmann::ordered_json json;
  json["format"] = kTableFormat;
  json["version"] =
      HasPrefilter(table.prefilter) || table.footprint != Footprint::k16 ? kTableVersion : 1;
  json["name"] = fit.name;
  json["scale"] = fit.scale;
  json["nodes"] = kNodes;
  WriteFootprint(table.footprint, json);
  json["storage"] = Name(table.format);
  json["fraction_bits"] = FractionBits(table.format);
  if (HasPrefilter(table.prefilter)) json["prefilter"] = ToJson(table.prefilter);
  json["provenance"] = Provenance(fit);
  json["certificate"] = ToJson(certificate);
  std::string text = JsonText(json, 1);
  text.resize(text.rfind("\n}"));
  text += ",\n \"values\": [\n";
  const std::vector<IntegerRow> rows = TableIntegers(table, fit.name);
  std::vector<std::int32_t> stored;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    stored.clear();
    for (const int k : TapsOf(table.footprint)) stored.push_back(rows[r][k]);
    text += fmt::format("  {}{}\n", fmt::join(stored, ","), r + 1 < rows.size() ? "," : "");
  }
  return text + " ]\n}\n";
}

// The halves that GPUs take, in every file that holds them.
std::vector<BakedFile> GpuFiles(const Fit& fit, const Certificate& certificate) {
  const BakedTable halves = QuantizeToHalves(SampleFit(fit, kNodes));
  const Table table(halves.view());
  const TableTexture texture = TextureOf(table);
  nlohmann::ordered_json known = ToJson(Certificate{
      CertifyStability(halves.view(), certificate.stability.blend), certificate.lookup_errors});
  known.erase("node_gains");
  KeyValues values = {{"KTXorientation", "rd"},
                      {"KTXwriter", "warplut bake"},
                      {"warplutCertificate", known.dump()}};
  if (HasPrefilter(table.prefilter()))
    values.emplace_back("warplutPrefilter", ToJson(table.prefilter()).dump());
  values.emplace_back("warplutProvenance", Provenance(fit).dump());
  values.emplace_back("warplutTaps", std::to_string(TapCount(table.footprint())));
  std::vector<BakedFile> files = {{".ktx2", EncodeKtx2(texture, values)},
                                  {".dds", EncodeDds(texture)},
                                  {".bin", EncodeTableFile(texture, table.prefilter())},
                                  {".test.json", TestVectors(fit.name, table)}};
  if (!HasShaderSource(table.footprint())) return files;
  const std::string banner = HeaderBanner(fit, certificate);
  files.push_back({".glsl", ShaderSource(fit.name, banner, table, ShaderLanguage::kGlsl)});
  files.push_back({".hlsl", ShaderSource(fit.name, banner, table, ShaderLanguage::kHlsl)});
  return files;
}

}  // namespace

std::vector<BakedFile> BakedFiles::All() const {
  std::vector<BakedFile> files = {{".h", header}, {".json", json}};
  if (!exr.empty()) files.push_back({".exr", exr});
  files.insert(files.end(), gpu.begin(), gpu.end());
  return files;
}

bool BakeOptions::IsValid(std::string* why) const {
  const bool valid = blend >= 0 && blend <= 1;
  if (why != nullptr)
    *why = valid ? "" : fmt::format("blend is {}, expected a number in [0, 1]", blend);
  return valid;
}

BakedFiles Bake(const Fit& fit, const BakeOptions& options) {
  std::string why;
  if (!options.IsValid(&why)) throw Error("cannot bake: " + why);
  if (!fit.IsValid(&why)) throw Error(fmt::format("cannot bake fit '{}': field {}", fit.name, why));
  const BakedTable table = Quantize(SampleFit(fit, kNodes), options.format);
  const Certificate certificate = Certify(fit, options.format, options.blend);
  return {fit.name, BakedHeader(fit, table.view(), certificate),
          BakedJson(fit, table.view(), certificate),
          HasReleasedLayout(fit) ? EncodeExr(ToReleasedLayout(fit)) : std::string(),
          GpuFiles(fit, certificate)};
}

void WriteBaked(const std::filesystem::path& folder, const BakedFiles& files) {
  for (const BakedFile& file : files.All())
    WriteFile(folder / (files.name + file.ending), file.bytes);
}

}  // namespace warplut
