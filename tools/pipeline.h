// What a person asks of a pipeline, checked and turned into the options of RunMode.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/sequence/sequence.h"
#include "luts/bake/table_io.h"
#include "luts/table.h"
#include "train/replay/mode_run.h"

namespace warplut {

// As on the command line. Exactly one of `lut` and `filter` is given.
struct PipelineArguments {
  std::string lut = {};
  std::string filter = {};         // bilinear, catmull-rom or keys:A
  std::string lookup = {};         // empty: bilinear
  std::string params = {};         // empty: the defaults
  std::string streams_below = {};  // ReadSequence; empty: below the manifest's folder
  std::string frames = {};         // A:B, numbers of the first and the last; empty: all
  int generated = 1;
  std::vector<float> alphas = {};
  std::string motion_filter = "auto";  // where a clip's motion is quantised; "on" or "off"
  float coherent_share = 0;            // of SuperResolutionOptions
  std::string history = {};            // rgba8, rgba16f, rgba32f; empty: the runtime's default
  bool texels = false;
  int threads = 0;
};

// An Error says which argument makes no sense; no file is opened.
void CheckArguments(const PipelineArguments& arguments);

// The lookup in a table that they ask for.
Lookup LookupOf(const PipelineArguments& arguments);

// A range of frames by index.
struct FrameRange {
  int first = 0;
  int count = 0;
};

// "A:B", frame numbers, both included; empty stands for all. Error: something else, or frames that
// the sequence does not have.
FrameRange ParseFrames(const std::string& text, const Sequence& sequence);

// The formats that a history can have, by name.
std::vector<std::string> HistoryFormatNames();

// The method of that name; an Error lists those that exist.
const MethodInfo& MethodOf(const std::string& name);

// The methods of these names, in their order. Error: a name that there is not, or one twice;
// `option` is the option that has them.
std::vector<const MethodInfo*> MethodsOf(const std::vector<std::string>& names,
                                         const std::string& option);

class Pipeline {
 public:
  // Reads the LUT and the parameters. Errors as LoadTable and ReadParameters.
  explicit Pipeline(const PipelineArguments& arguments);
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  // For RunMode; the pipeline outlives its use.
  ModeRunOptions Options(const MethodInfo& method, int every) const;

  // What ReadSequence takes beside the manifest.
  const std::string& streams_below() const { return arguments_.streams_below; }

  // The filter's name: of the table, or as it was given.
  const std::string& filter_name() const { return filter_name_; }

  // A sentence if the LUT was fitted for another upscale factor than that of the sequence, and what
  // that costs.
  std::optional<std::string> ScaleWarning(const Sequence& sequence) const;

  // The frames of the range with the streams that the methods take and `more`, texels taken if
  // asked for. Composed motion is filtered as the arguments say, or not at all (`raw_motion`: the
  // filter itself is looked into). Error if the sequence lacks a stream (LoadFrame), or as
  // TakeTexels.
  Clip Load(const Sequence& sequence, const FrameRange& range,
            const std::vector<const MethodInfo*>& methods, Streams more, int every,
            bool raw_motion = false) const;

 private:
  PipelineArguments arguments_;
  std::string filter_name_;
  std::optional<LoadedTable> loaded_;
  std::optional<Table> table_;
  WarpOptions warp_;
  Parameters parameters_;
};

// Reads the sequence for a command that runs these methods: the manifest, and a warning where the
// LUT was fitted for another scale and one of them keeps a history, whose warps depend on the
// scale.
Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path,
                         const std::vector<const MethodInfo*>& methods);

}  // namespace warplut
