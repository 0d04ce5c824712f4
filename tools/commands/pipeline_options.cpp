#include "tools/commands/pipeline_options.h"

#include <algorithm>

#include "tools/device.h"
#include "tools/judge/images/protocol_filter.h"
#include "tools/terminal/warning.h"

namespace warplut {

void AddTableOptions(Command command, PipelineArguments* arguments) {
  command.Add(
      "--lut", arguments->lut,
      "Table of the filter: a fit, a baked table (.json) or an .exr in the released layout");
  command
      .Add("--lookup", arguments->lookup, "Lookup between nodes of the table (default: bilinear)")
      .OneOf({Name(Lookup::kNearest), Name(Lookup::kBilinear)});
  command.Add("--threads", arguments->threads, "Number of threads (default: all cores)")
      .Within(0, 1024);
}

void AddStreamsBelowOption(Command command, std::string* folder) {
  command.Add("--streams-below", *folder,
              "Folder that streams may lie below (default: the manifest's folder)");
}

void AddPipelineOptions(Command command, PipelineArguments* arguments) {
  PipelineArguments& a = *arguments;
  AddStreamsBelowOption(command, &a.streams_below);
  command.Add("--filter", a.filter, "Closed-form filter instead of a table: " + WarpNames());
  command.Add("--params", a.params, "File of calibrated parameters (default: built-in parameters)");
  command.Add("--frames", a.frames, "First and last frame to use, as A:B (default: all)");
  CommandOption generated =
      command
          .Add("--generated", a.generated, "Number of generated frames between two rendered ones")
          .ShowDefault();
  command.Add("--alpha", a.alphas, "Times of generated frames in (0, 1), instead of --generated")
      .Separated()
      .Excludes(generated);
  command
      .Add("--motion-filter", a.motion_filter,
           "Remove quantisation from motion vectors; auto removes it where they are quantised")
      .OneOf({"on", "off", "auto"})
      .ShowDefault();
  command.Add("--history", a.history, "Pixel format of the history (default: rgba16f)")
      .OneOf(HistoryFormatNames());
  command
      .Add("--coherent-share", a.coherent_share,
           "Share of residuals that agree with those around, against lattices where light changes; "
           "0.7 is a good one")
      .ShowDefault();
  command.AddFlag(
      "--texels", a.texels,
      "Take render-grid colour from texels of the reference, in the order of the jitter");
}

CommandOption AddDeviceOption(Command command, std::string* device) {
  return command.Add("--device", *device, "Device that computes the frames")
      .OneOf(DeviceNames())
      .ShowDefault();
}

CommandOption AddSettledOption(Command command, int* settled) {
  return command.Add("--settled", *settled, "Also print means without the first N judged frames")
      .Within(1, 1 << 20);
}

}  // namespace warplut
