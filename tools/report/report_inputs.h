// What every section of the report is made from.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sequence/sequence.h"
#include "luts/fit/fit.h"
#include "luts/quantize/baked_table.h"
#include "luts/table.h"
#include "runtime/warp.h"
#include "train/replay/clip.h"
#include "train/replay/mode_run.h"

namespace warplut {

// Where a method generates, one of so many frames is rendered and the others are there to judge by.
inline constexpr int kReportEvery = 2;

// A table ready for the kernels. The options of Warp() point into it: it outlives them.
struct ReportLut {
  std::string name;
  std::optional<Fit>
      fit;  // where the file was a fit: its MLP gives the exact weights of any offset
  std::optional<double> scale;  // upscale factor it was fitted for
  std::unique_ptr<const BakedTable> baked;
  std::unique_ptr<const Table> table;

  WarpOptions Warp(Lookup lookup = Lookup::kBilinear) const {
    return {.filter = Filter::kLut, .table = table.get(), .lookup = lookup};
  }
};

// One sequence in memory. Streams that it lacks are empty in its frames; color, reference and
// reference_motion are there.
struct ReportClip {
  std::string name;   // of the sequence; unique among the clips
  Sequence sequence;  // its manifest; frames can be read again from its files
  bool built_in = false;
  Clip dense;   // every frame with every stream, motion from frame to frame
  Clip sparse;  // what methods that generate take: motion over kReportEvery frames

  const Clip& ClipFor(bool generates) const { return generates ? sparse : dense; }
};

struct ReportInputs {
  bool quick = false;
  std::uint64_t seed = 1;
  int threads = 0;  // at most; 0: one per core
  // Wall time in which the section at hand is to be done; it takes less of its problems where they
  // would last longer, and says so in `failures`. Set anew for each section.
  double seconds = 0;
  std::string command_line;  // that made the report
  std::string
      sequences;  // as on the command line, for ReportSection::command: "" or " --sequence A B"
  ReportLut warp_lut;      // for repeated warps alone
  ReportLut pipeline_lut;  // for the history of super resolution
  std::vector<ReportClip> clips;
  std::vector<ReportClip>
      // the same scenes with more pixels, fewer of them; empty for a person's own sequences
      larger_clips;
  // Called at least each second with the share of the section's work that is done, from any thread.
  // Throws an Error when the program is to stop, which the section lets pass.
  std::function<void(double share, const std::string& note)> progress = [](double, const auto&) {};
};

// How a method is run in the report: its defaults, with the table of the pipeline, and with the
// motion filter where motion is quantised. `inputs` outlives the options.
inline ModeRunOptions ReportRunOptions(const ReportInputs& inputs, const MethodInfo& method) {
  ModeRunOptions options;
  options.method = &method;
  options.every = method.generation == Generation::kNone ? 1 : kReportEvery;
  options.super_resolution.warp = inputs.pipeline_lut.Warp();
  options.generation.warp = inputs.pipeline_lut.Warp();
  options.filter_quantised_motion = true;
  return options;
}

}  // namespace warplut
