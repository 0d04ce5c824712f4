// Prints the table of docs/results/gpu.md: the work of each pass, and the least time that a phone's
// GPU needs for it.
#include <cstdio>
#include <vector>

#include "luts/baked/warplut_iir_x2.h"
#include "luts/baked/warplut_sr_x2.h"
#include "runtime/gpu/pass_work.h"

namespace {

// A GPU of the class of the phones that games target.
constexpr double kBytesPerSecond = 60e9, kOperationsPerSecond = 2e12;

void PrintRow(const warplut::PassWork& work) {
  std::printf("| %s | %.0f | %.1f | %.0f | %.1f | %.3f |\n", work.pass.c_str(), work.pixels,
              work.fetches, work.operations, work.bytes,
              warplut::RooflineMilliseconds(work, kBytesPerSecond, kOperationsPerSecond));
}

constexpr const char* kHeading =
    "| pass | pixels | fetches | operations | bytes | ms |\n|---|---:|---:|---:|---:|---:|\n";

void PrintRows(const std::vector<warplut::PassWork>& passes) {
  double milliseconds = 0;
  for (const warplut::PassWork& work : passes) {
    PrintRow(work);
    milliseconds += warplut::RooflineMilliseconds(work, kBytesPerSecond, kOperationsPerSecond);
  }
  std::printf("| all | | | | | %.3f |\n", milliseconds);
}

void PrintTable(const char* name, const warplut::TableView& view) {
  const warplut::Table table(view);
  warplut::SuperResolutionOptions options;
  options.render_width = 960;
  options.render_height = 540;
  options.output_width = 1920;
  options.output_height = 1080;
  options.warp = {.filter = warplut::Filter::kLut, .table = &table};
  std::printf("\n%s, super resolution, 960 x 540 to 1920 x 1080:\n\n%s", name, kHeading);
  PrintRows(warplut::WorkOf(options));
  PrintRow(warplut::NineTapWarp(options));
  warplut::FrameGenerationOptions generation;
  generation.width = options.output_width;
  generation.height = options.output_height;
  generation.warp = options.warp;
  for (const bool interpolates : {true, false}) {
    std::printf("\n%s, %s, 1920 x 1080:\n\n%s", name,
                interpolates ? "interpolation" : "extrapolation", kHeading);
    PrintRows(warplut::WorkOf(generation, interpolates));
  }
}

}  // namespace

int main() {
  PrintTable("`warplut_iir_x2`, with a prefilter", warplut::baked::kWarplutIirX2);
  PrintTable("`warplut_sr_x2`, without", warplut::baked::kWarplutSrX2);
}
