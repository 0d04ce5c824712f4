#include "tools/bench/benchmark_tables.h"

#include <fmt/format.h>

namespace warplut {
namespace {

Json ToJson(const Timing& timing) {
  return {{"min", timing.min}, {"median", timing.median}, {"max", timing.max}};
}

// The median of milliseconds.
Cell TimeCell(const Timing& time, int digits) {
  return {.value = ToJson(time), .text = fmt::format("{:.{}f}", time.median, digits)};
}

Cell RatioCell(const Timing& ratio) {
  return {.value = ToJson(ratio),
          .text = fmt::format("{:.2f} [{:.2f}, {:.2f}]", ratio.median, ratio.min, ratio.max)};
}

// A target that is missed is marked; without one (0) there is nothing to read.
template <class Row>
Cell TargetCell(const Row& row) {
  return {.value = row.target,
          .text = row.target > 0 ? fmt::format("{:.1f}{}", row.target, row.met() ? "" : "!") : ""};
}

template <class Row>
Cell MetCell(const Row& row) {
  return {.value = row.met(), .text = {}};
}

template <class Row>
Cell SizeCell(const Row& row) {
  return {.value = {row.width, row.height}, .text = fmt::format("{} x {}", row.width, row.height)};
}

using WarpRow = WarpBenchmarkRow;
const Columns<WarpRow> kWarpColumns = {
    {"format", "format", [](const WarpRow& row) { return TextCell(Name(row.format)); }},
    {"motion", "motion", [](const WarpRow& row) { return TextCell(row.motion); }},
    {"filter", "filter", [](const WarpRow& row) { return TextCell(row.filter); }},
    {"competitor", "competitor", [](const WarpRow& row) { return TextCell(row.competitor); }},
    {"warp_ms", "warp ms", [](const WarpRow& row) { return TimeCell(row.warp, 3); }},
    {"competitor_ms", "other ms", [](const WarpRow& row) { return TimeCell(row.other, 3); }},
    {"ratio", "ratio median [min, max]", [](const WarpRow& row) { return RatioCell(row.ratio); }},
    {"target", "target", TargetCell},
    {"met", "", MetCell},
    {"worst_error_codes", "against reference", [](const WarpRow& row) {
       return Cell{.value = row.worst_error,
                   .text = row.exact ? "exact" : fmt::format("{:.2g} codes", row.worst_error)};
     }}};

using SrRow = SrBenchmarkRow;
const Columns<SrRow> kSrColumns = {
    {"output", "output", SizeCell},
    {"motion", "motion", [](const SrRow& row) { return TextCell(row.motion); }},
    {"variant", "variant", [](const SrRow& row) { return TextCell(row.variant); }},
    {"frame_ms", "frame ms", [](const SrRow& row) { return TimeCell(row.process, 3); }},
    {"warp_ms", "warp ms", [](const SrRow& row) { return TimeCell(row.warp, 3); }},
    {"ratio", "ratio median [min, max]", [](const SrRow& row) { return RatioCell(row.ratio); }},
    {"target", "target", TargetCell},
    {"met", "", MetCell},
    {"differing_share", "differ",
     [](const SrRow& row) {
       return Cell{.value = row.flipped, .text = fmt::format("{:.1e}", row.flipped)};
     }},
    {"memory_images", "memory", [](const SrRow& row) { return NumberCell(row.memory, 2); }}};

using GenerationRow = GenerationBenchmarkRow;
const Columns<GenerationRow> kGenerationColumns = {
    {"size", "size", SizeCell},
    {"format", "format", [](const GenerationRow& row) { return TextCell(row.content); }},
    {"motion", "motion", [](const GenerationRow& row) { return TextCell(row.motion); }},
    {"interpolates", "frame at",
     [](const GenerationRow& row) {
       return Cell{.value = row.interpolates, .text = row.interpolates ? "alpha" : "1 + alpha"};
     }},
    {"frame_ms", "frame", [](const GenerationRow& row) { return TimeCell(row.frame, 2); }},
    {"warp_ms", "warp", [](const GenerationRow& row) { return TimeCell(row.warp, 2); }},
    {"ratio", "ratio [min, max]", [](const GenerationRow& row) { return RatioCell(row.ratio); }},
    {"forward_ms", "forward", [](const GenerationRow& row) { return TimeCell(row.forward, 2); }},
    {"splat_ms", "splat", [](const GenerationRow& row) { return TimeCell(row.splat, 2); }},
    {"target_motion_ms", "target motion",
     [](const GenerationRow& row) { return TimeCell(row.target_motion, 2); }},
    {"blend_ms", "blend", [](const GenerationRow& row) { return TimeCell(row.blend, 2); }},
    {"target", "target", TargetCell},
    {"met", "", MetCell},
    {"memory_images", "memory",
     [](const GenerationRow& row) { return NumberCell(row.memory, 2); }}};

using PassRow = PassBenchmarkRow;
const Columns<PassRow> kPassColumns = {
    {"mode", "mode", [](const PassRow& row) { return TextCell(row.mode); }},
    {"pass", "pass", [](const PassRow& row) { return TextCell(row.pass); }},
    {"ms", "ms [min, max]", [](const PassRow& row) { return RatioCell(row.time); }}};

// The first `words` columns hold words.
template <class Row>
std::string RowsText(const Columns<Row>& columns, const std::vector<Row>& rows, std::size_t words) {
  TextTable table = RecordTable(columns, rows);
  table.left = words;
  return ToText(table);
}

}  // namespace

std::string ToText(const WarpBenchmark& benchmark) {
  return fmt::format("Warp on {}, OpenCV {}, one thread; ratio = competitor / warp\n{}",
                     benchmark.target, benchmark.opencv, RowsText(kWarpColumns, benchmark.rows, 4));
}

std::string ToText(const std::vector<SrBenchmarkRow>& rows) {
  return "Super resolution, one thread; ratio = frame / warp of an RGBA16F history alone\n" +
         RowsText(kSrColumns, rows, 3) +
         "differ: share of pixels that differ from the plain version by more than half a code "
         "value; memory: in RGBA16F images of the output.\n";
}

std::string ToText(const std::vector<GenerationBenchmarkRow>& rows) {
  return "Frame generation, one thread; milliseconds; ratio = frame / one warp of a source\n" +
         RowsText(kGenerationColumns, rows, 4) + "memory: in RGBA16F images.\n";
}

std::string ToText(const PassBenchmark& benchmark) {
  return fmt::format("Passes on {}; median of the device's milliseconds\n{}", benchmark.device,
                     RowsText(kPassColumns, benchmark.rows, 2));
}

std::string ToText(const SsimBenchmark& b) {
  return fmt::format(
      "SSIM with gradient, one thread: {:.0f} Mpixel/s ({:.0f} wanted), {:.0f} with preparing the "
      "reference image;\n"
      "{:.1f} times faster than the value alone with OpenCV's GaussianBlur; error {:.1e}\n",
      b.mpixels, kSsimTargetMpixels, b.prepared_mpixels, b.opencv_ratio, b.error);
}

Json ToJson(const WarpBenchmark& benchmark) {
  return {{"target", benchmark.target},
          {"opencv", benchmark.opencv},
          {"rows", RecordsJson(kWarpColumns, benchmark.rows)}};
}

Json ToJson(const std::vector<SrBenchmarkRow>& rows) {
  return {{"rows", RecordsJson(kSrColumns, rows)}};
}

Json ToJson(const std::vector<GenerationBenchmarkRow>& rows) {
  return {{"rows", RecordsJson(kGenerationColumns, rows)}};
}

Json ToJson(const PassBenchmark& benchmark) {
  return {{"device", benchmark.device}, {"rows", RecordsJson(kPassColumns, benchmark.rows)}};
}

Json ToJson(const SsimBenchmark& b) {
  return {{"mpixels", b.mpixels},
          {"prepared_mpixels", b.prepared_mpixels},
          {"opencv_ratio", b.opencv_ratio},
          {"error", b.error}};
}

}  // namespace warplut
