#include "tools/pipeline_options.h"

#include "tools/judge/protocol_filter.h"
#include "tools/warning.h"

namespace warplut {

void AddTableOptions(CLI::App& command, PipelineArguments* arguments) {
  command.add_option("--lut", arguments->lut,
                     "A fit, a baked table (.json), or an .exr in the released layout");
  command.add_option("--lookup", arguments->lookup, "In the table (default: bilinear)")
      ->check(CLI::IsMember({Name(Lookup::kNearest), Name(Lookup::kBilinear)}));
  command.add_option("--threads", arguments->threads, "Threads (default: all)")
      ->check(CLI::Range(0, 1024));
}

void AddPipelineOptions(CLI::App& command, PipelineArguments* arguments) {
  PipelineArguments& a = *arguments;
  command.add_option("--filter", a.filter, "In place of a LUT: " + WarpNames());
  command.add_option("--params", a.params, "Calibrated parameters (default: the built-in ones)");
  command.add_option("--frames", a.frames, "A:B, the first and the last frame (default: all)");
  CLI::Option* generated =
      command.add_option("--generated", a.generated, "Generated frames between two rendered ones")
          ->capture_default_str();
  command.add_option("--alpha", a.alphas, "Times of generated frames in (0, 1), in place of that")
      ->delimiter(',')
      ->excludes(generated);
  command
      .add_option("--motion-filter", a.motion_filter,
                  "Take quantisation out of the motion vectors; auto: where they are quantised")
      ->check(CLI::IsMember({"on", "off", "auto"}))
      ->capture_default_str();
  command.add_option("--history", a.history, "Format of the history (default: rgba16f)")
      ->check(CLI::IsMember(HistoryFormatNames()));
  command.add_flag("--texels", a.texels,
                   "Render by taking texels of the reference, in the order of the jitter");
}

CLI::Option* AddSettledOption(CLI::App& command, int* settled) {
  return command
      .add_option("--settled", *settled,
                  "Print the means without the first so many judged frames, too")
      ->check(CLI::Range(1, 1 << 20));
}

Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path) {
  Sequence sequence = ReadSequence(path);
  if (const auto warning = pipeline.ScaleWarning(sequence)) Warn(*warning);
  return sequence;
}

}  // namespace warplut
