#include "tools/pipeline_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <map>

namespace warplut {

void AddPipelineOptions(CLI::App& command, PipelineArguments* arguments) {
  PipelineArguments& a = *arguments;
  command.add_option("--filter", a.filter, "In place of a LUT: bilinear, catmull-rom or keys:A");
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
                  "on: take quantisation out of the motion vectors (default: off)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, std::string>{{"on", "true"}, {"off", "false"}}));
  command.add_option("--history", a.history, "Format of the history (default: rgba16f)")
      ->check(CLI::IsMember(HistoryFormatNames()));
  command.add_flag("--texels", a.texels,
                   "Render by taking texels of the reference, in the order of the jitter");
}

void Warn(const std::string& sentence) { fmt::print(stderr, "warplut: warning: {}.\n", sentence); }

Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path) {
  Sequence sequence = ReadSequence(path);
  if (const auto warning = pipeline.ScaleWarning(sequence)) Warn(*warning);
  return sequence;
}

}  // namespace warplut
