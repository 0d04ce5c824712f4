#include "tools/profile/profile_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace warplut {
namespace {

std::string Signed(double value, int digits) { return SignedCell(value, digits).text; }

std::string TimeText(const TimeRatio& time) {
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", time.median, time.low, time.high);
}

Json ToJson(const TimeRatio& time) {
  return {{"median", time.median}, {"min", time.low}, {"max", time.high}};
}

// People read changes, programs losses.
const Columns<PipelineCost> kCostColumns = {
    {"ssim_loss", "SSIM",
     [](const PipelineCost& cost) {
       return Cell{.value = cost.loss, .text = Signed(-cost.loss, 5)};
     }},
    {"psnr_loss", "PSNR dB",
     [](const PipelineCost& cost) {
       return Cell{.value = FiniteJson(cost.psnr_loss), .text = Signed(-cost.psnr_loss, 2)};
     }},
    {"temporal_growth", "temporal",
     [](const PipelineCost& cost) {
       return Cell{.value = FiniteJson(cost.temporal_growth),
                   .text = Signed(cost.temporal_growth, 5)};
     }},
    {"time", "time [min, max]", [](const PipelineCost& cost) {
       return Cell{.value = ToJson(cost.time), .text = TimeText(cost.time)};
     }}};

std::vector<std::string> CostCells(const std::string& name, const PipelineCost& cost) {
  std::vector<std::string> row = RecordRow(kCostColumns, cost);
  row.insert(row.begin(), name);
  return row;
}

TextTable CostTable(const std::string& first) {
  TextTable table = RecordHeader(kCostColumns);
  table.header.insert(table.header.begin(), first);
  return table;
}

Json ToJson(const PipelineCost& cost) { return RecordJson(kCostColumns, cost); }

std::string LookupText(const SmallerTable& table) {
  return fmt::format("{} nodes, {}, {} lookup", table.nodes, Name(table.format),
                     Name(table.lookup));
}

std::vector<std::string> ParameterNamesOf(const std::vector<int>& parameters) {
  std::vector<std::string> names;
  for (const int index : parameters) {
    names.emplace_back(kParameters[static_cast<std::size_t>(index)].name);
  }
  return names;
}

std::string JoinedOr(const std::vector<std::string>& names, const char* none) {
  return names.empty() ? none : fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string> OmittedNames(const ProfileResult& result) {
  std::vector<std::string> names;
  for (const OmissionTrial& trial : result.taken) names.emplace_back(trial.omission->name);
  return names;
}

// Whether the errors are those against the full pipeline's own output.
bool LacksReference(const ProfileReport& report) {
  return std::any_of(report.sequences.begin(), report.sequences.end(),
                     [](const ProfiledSequence& sequence) { return !sequence.has_reference; });
}

std::string TableSentence(const ProfileReport& report) {
  if (!report.full.ReadsTable()) return "The pipeline reads no table.";
  if (!report.tables_in_chosen) {
    return "The chosen pipeline reads no table; the sizes below are for the full one.";
  }
  if (!report.table) return "No smaller table is within the bound in the chosen pipeline.";
  return fmt::format("The smallest table within the bound that can be baked: {}, {} bytes{}.",
                     LookupText(*report.table), report.table->least_bytes(),
                     report.table->eighth_bytes
                         ? fmt::format(" as the eighth that its symmetries leave (all nodes: {})",
                                       report.table->bytes)
                         : "");
}

// How the proposed table is made.
std::string BakeSentence(const ProfileReport& report) {
  if (!report.table) return "";
  if (report.bake.empty()) {
    return fmt::format("To make it, bake the fit of {} with --format {}.\n", report.filter,
                       Name(report.table->format));
  }
  return fmt::format("To make it: {}\n", report.bake);
}

std::string ParameterSentence(const ProfileReport& report) {
  return fmt::format("Parameters that the chosen pipeline reads: {}.",
                     JoinedOr(ParameterNamesOf(report.result.chosen.parameters), "none"));
}

Json ToJson(const std::vector<OmissionTrial>& trials) {
  Json list = Json::array();
  for (const OmissionTrial& trial : trials) {
    Json one = {{"name", trial.omission->name}, {"meaning", trial.omission->meaning}};
    one.update(ToJson(trial.cost));
    list.push_back(std::move(one));
  }
  return list;
}

Json ToJson(const SmallerTable& table) {
  Json json = {{"nodes", table.nodes},
               {"storage", Name(table.format)},
               {"lookup", Name(table.lookup)},
               {"bytes", table.bytes}};
  if (table.eighth_bytes) json["eighth_bytes"] = *table.eighth_bytes;
  json["ssim_loss"] = table.cost.loss;
  json["psnr_loss"] = FiniteJson(table.cost.psnr_loss);
  json["can_be_baked"] = table.CanBeBaked();
  return json;
}

Json ToJson(const FrameTiles& tiles) {
  Json json = {{"tiles", tiles.total}, {"disoccluded", tiles.disoccluded}};
  for (int kind = 0; kind < kMotionKinds; ++kind) {
    json[Name(static_cast<MotionKind>(kind))] = tiles.warped[static_cast<MotionKind>(kind)];
  }
  return json;
}

void AddTileRow(const std::string& name, const char* what, const FrameTiles& tiles,
                TextTable* table) {
  if (tiles.total == 0) return;
  std::vector<std::string> row = {fmt::format("{}, {}", name, what)};
  for (int kind = 0; kind < kMotionKinds; ++kind) {
    row.push_back(
        fmt::format("{:.1f} %", 100 * Share(tiles.warped, static_cast<MotionKind>(kind))));
  }
  row.push_back(fmt::format(
      "{:.1f} %", 100 * static_cast<double>(tiles.disoccluded) / static_cast<double>(tiles.total)));
  table->rows.push_back(std::move(row));
}

}  // namespace

TextTable SummaryTable(const ProfileReport& report) {
  const ProfileResult& result = report.result;
  std::vector<std::string> names;
  for (const ProfiledSequence& sequence : report.sequences) names.push_back(sequence.name);
  return {
      .header = {"sequences", "mode", "ms", "time [min, max]", "as it ships", "SSIM", "left out"},
      .rows = {{fmt::format("{}", fmt::join(names, ", ")), report.mode,
                fmt::format("{:.2f}", result.checked_full_milliseconds),
                TimeText(result.checked.time), fmt::format("{:.2f}", result.shipped.time.median),
                Signed(-result.checked.loss, 5), JoinedOr(OmittedNames(result), "nothing")}}};
}

TextTable AloneTable(const ProfileReport& report) {
  TextTable table = CostTable("left out alone");
  for (const OmissionTrial& trial : report.result.alone) {
    table.rows.push_back(CostCells(trial.omission->name, trial.cost));
  }
  return table;
}

TextTable TogetherTable(const ProfileReport& report) {
  const ProfileResult& result = report.result;
  TextTable table = CostTable("left out together");
  for (const OmissionTrial& trial : result.taken) {
    table.rows.push_back(CostCells(trial.omission->name, trial.cost));
  }
  for (const OmissionTrial& trial : result.given_back) {
    table.rows.push_back(
        CostCells(fmt::format("{} (given back)", trial.omission->name), trial.cost));
  }
  table.rows.push_back(CostCells("chosen, all frames", result.checked));
  table.rows.push_back(CostCells(fmt::format("{} as it ships", report.mode), result.shipped));
  return table;
}

TextTable TablesTable(const ProfileReport& report) {
  TextTable table{.header = {"table", "SSIM", "PSNR dB", "bytes", "an eighth"}, .rows = {}};
  for (const SmallerTable& smaller : report.tables) {
    table.rows.push_back({LookupText(smaller), Signed(-smaller.cost.loss, 5),
                          Signed(-smaller.cost.psnr_loss, 2), fmt::format("{}", smaller.bytes),
                          smaller.eighth_bytes ? fmt::format("{}", *smaller.eighth_bytes) : "-"});
  }
  return table;
}

TextTable TileTable(const ProfileReport& report) {
  TextTable table{.header = {"tiles"}, .rows = {}};
  for (int kind = 0; kind < kMotionKinds; ++kind) {
    table.header.emplace_back(Name(static_cast<MotionKind>(kind)));
  }
  table.header.emplace_back("disoccluded");
  for (std::size_t i = 0; i < report.tiles.size(); ++i) {
    const std::string& name = report.sequences[i].name;
    AddTileRow(name, "history", report.tiles[i].history, &table);
    AddTileRow(name, "generated", report.tiles[i].generated, &table);
  }
  return table;
}

std::string ToText(const ProfileReport& report) {
  const ProfileResult& result = report.result;
  std::string text = fmt::format("{} with {}: every pass takes {:.2f} ms for a frame, one thread\n",
                                 report.mode, report.filter, result.checked_full_milliseconds);
  TextTable full{.header = {"every pass", "PSNR dB", "SSIM", "temporal"}, .rows = {}};
  for (std::size_t i = 0; i < report.sequences.size(); ++i) {
    const PipelineScore& score = result.checked_full_scores[i];
    full.rows.push_back({report.sequences[i].name, PsnrCell(score.mean.psnr).text,
                         fmt::format("{:.5f}", score.mean.ssim),
                         NumberCell(score.temporal_error, 5).text});
  }
  text += ToText(full);
  if (LacksReference(report)) {
    text +=
        "Sequences without references are judged against what every pass together makes of them.\n";
  }
  text += fmt::format(
      "\n{}\n{}Changes on the sequence where they are worst; time as a share of that of every "
      "pass.\n",
      ToText(AloneTable(report)), ToText(TogetherTable(report)));
  for (const OmissionTrial& trial : result.taken) {
    text += fmt::format("Without {}: {}.\n", trial.omission->name, trial.omission->meaning);
  }
  text += fmt::format("{}\n{}\n{}", ParameterSentence(report), TableSentence(report),
                      BakeSentence(report));
  if (!report.tables.empty()) {
    text += fmt::format(
        "\n{}Tables of fewer than {} nodes are for renderers that look weights up themselves: bake "
        "does not make them.\n",
        ToText(TablesTable(report)), kNodes);
  }
  const TextTable tiles = TileTable(report);
  if (!tiles.rows.empty()) {
    text += fmt::format("\n{}Time of every pass by that without a look at the tiles' motion: {}.\n",
                        ToText(tiles), TimeText(report.time_by_tiles));
  }
  return text;
}

Json ToJson(const ProfileReport& report) {
  const ProfileResult& result = report.result;
  Json sequences = Json::array();
  for (std::size_t i = 0; i < report.sequences.size(); ++i) {
    const ProfiledSequence& sequence = report.sequences[i];
    const PipelineScore& full = result.checked_full_scores[i];
    const PipelineScore& chosen = result.checked.scores[i];
    sequences.push_back(
        {{"name", sequence.name},
         {"sha1", sequence.sha1},
         {"reference", sequence.has_reference},
         {"full", {{"ssim", full.mean.ssim}, {"psnr", FiniteJson(full.mean.psnr)}}},
         {"chosen", {{"ssim", chosen.mean.ssim}, {"psnr", FiniteJson(chosen.mean.psnr)}}},
         {"history_tiles", ToJson(report.tiles[i].history)},
         {"generated_tiles", ToJson(report.tiles[i].generated)}});
  }
  Json json = {{"mode", report.mode},
               {"filter", report.filter},
               {"within", report.within},
               {"sequences", sequences},
               {"full_milliseconds", result.checked_full_milliseconds},
               {"alone", ToJson(result.alone)},
               {"left_out", ToJson(result.taken)},
               {"given_back", ToJson(result.given_back)},
               {"chosen", ToJson(result.checked)},
               {"shipped", ToJson(result.shipped)},
               {"parameters", ParameterNamesOf(result.chosen.parameters)}};
  Json tables = Json::array();
  for (const SmallerTable& table : report.tables) tables.push_back(ToJson(table));
  json["tables_in_chosen"] = report.tables_in_chosen;
  json["tables"] = tables;
  json["table"] = report.table ? ToJson(*report.table) : Json(nullptr);
  json["bake"] = report.bake.empty() ? Json(nullptr) : Json(report.bake);
  json["time_by_tiles"] = ToJson(report.time_by_tiles);
  return json;
}

std::vector<std::string> Banner(const ProfileReport& report) {
  const ProfileResult& result = report.result;
  std::vector<std::string> lines = {
      fmt::format("Generated by warplut profile {}, do not edit.", report.version), "",
      fmt::format("Mode {}, filter {}; at most {} of SSIM below every pass together.", report.mode,
                  report.filter, report.within),
      "Sequences (sha1 of the manifest):"};
  for (const ProfiledSequence& sequence : report.sequences) {
    lines.push_back(fmt::format("  {} {}{}", sequence.sha1, sequence.name,
                                sequence.has_reference ? "" : ", without references"));
  }
  lines.push_back(fmt::format("Left out: {}.", JoinedOr(OmittedNames(result), "nothing")));
  for (std::size_t i = 0; i < report.sequences.size(); ++i) {
    lines.push_back(fmt::format("SSIM of {}: {:.5f} with every pass, {:.5f} with these.",
                                report.sequences[i].name, result.checked_full_scores[i].mean.ssim,
                                result.checked.scores[i].mean.ssim));
  }
  lines.push_back(
      fmt::format("Measured: {:.2f} ms for a frame with every pass, {:.2f} of that with these "
                  "[{:.2f}, {:.2f}].",
                  result.checked_full_milliseconds, result.checked.time.median,
                  result.checked.time.low, result.checked.time.high));
  lines.push_back(ParameterSentence(report));
  lines.push_back(TableSentence(report));
  if (result.chosen.WarpsFrames() || !result.chosen.Generates()) return lines;
  lines.push_back(result.chosen.generator == Generator::kRepeat
                      ? "Generated frames: the frame before, again."
                      : "Generated frames: a blend of the frames before and after.");
  return lines;
}

std::string ToMarkdown(const ProfileReport& report) {
  std::string text = ToMarkdown(SummaryTable(report));
  for (const TextTable& table :
       {AloneTable(report), TogetherTable(report), TablesTable(report), TileTable(report)}) {
    if (!table.rows.empty()) text += '\n' + ToMarkdown(table);
  }
  return text;
}

}  // namespace warplut
