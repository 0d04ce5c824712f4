#include "tools/pipeline_options.h"

#include <algorithm>

#include "tools/judge/protocol_filter.h"
#include "tools/warning.h"

namespace warplut {

void AddTableOptions(CLI::App& command, PipelineArguments* arguments) {
  command.add_option(
      "--lut", arguments->lut,
      "Table of the filter: a fit, a baked table (.json) or an .exr in the released layout");
  command
      .add_option("--lookup", arguments->lookup,
                  "Lookup between nodes of the table (default: bilinear)")
      ->check(CLI::IsMember({Name(Lookup::kNearest), Name(Lookup::kBilinear)}));
  command.add_option("--threads", arguments->threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(0, 1024));
}

void AddPipelineOptions(CLI::App& command, PipelineArguments* arguments) {
  PipelineArguments& a = *arguments;
  command.add_option("--filter", a.filter, "Closed-form filter instead of a table: " + WarpNames());
  command.add_option("--params", a.params,
                     "File of calibrated parameters (default: built-in parameters)");
  command.add_option("--frames", a.frames, "First and last frame to use, as A:B (default: all)");
  CLI::Option* generated = command
                               .add_option("--generated", a.generated,
                                           "Number of generated frames between two rendered ones")
                               ->capture_default_str();
  command
      .add_option("--alpha", a.alphas,
                  "Times of generated frames in (0, 1), instead of --generated")
      ->delimiter(',')
      ->excludes(generated);
  command
      .add_option(
          "--motion-filter", a.motion_filter,
          "Remove quantisation from motion vectors; auto removes it where they are quantised")
      ->check(CLI::IsMember({"on", "off", "auto"}))
      ->capture_default_str();
  command.add_option("--history", a.history, "Pixel format of the history (default: rgba16f)")
      ->check(CLI::IsMember(HistoryFormatNames()));
  command.add_flag(
      "--texels", a.texels,
      "Take render-grid colour from texels of the reference, in the order of the jitter");
}

CLI::Option* AddSettledOption(CLI::App& command, int* settled) {
  return command
      .add_option("--settled", *settled, "Also print means without the first N judged frames")
      ->check(CLI::Range(1, 1 << 20));
}

Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path,
                         const std::vector<const MethodInfo*>& methods) {
  Sequence sequence = ReadSequence(path);
  if (std::none_of(methods.begin(), methods.end(),
                   [](const MethodInfo* method) { return HasHistory(*method); })) {
    return sequence;
  }
  if (const auto warning = pipeline.ScaleWarning(sequence)) Warn(*warning);
  return sequence;
}

}  // namespace warplut
