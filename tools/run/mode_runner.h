// Methods over a sequence, their frames as files: what `warplut run` does.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "tools/device.h"
#include "tools/judge/sequence_report.h"
#include "tools/pictures/shown_file.h"
#include "tools/pipeline.h"

namespace warplut {

struct RunRequest {
  std::vector<std::string> modes;  // names of methods
  std::string sequence;
  std::string out;     // a folder; several modes write into OUT/MODE each
  std::string format;  // png or exr; empty: png, exr if linear
  std::string device = DeviceNames().front();
  int every = 1;
  bool score = false;
  int settled = 0;  // of the score
  PipelineArguments pipeline;
};

// What one mode wrote.
struct ModeOutput {
  std::string mode;
  std::filesystem::path folder;
  std::vector<std::string> files;
  std::optional<SequenceReport> scores;
};

class ModeRunner {
 public:
  // Reads the sequence's manifest; `request` outlives the object. UsageError: a request that makes
  // no sense. Error: a sequence, a table or a device that cannot be used.
  explicit ModeRunner(const RunRequest& request);

  // Runs the modes, one after the other. Error: a folder that cannot be written, a stream or a
  // choice that one of the modes lacks (told before the first one runs), an interruption.
  std::vector<ModeOutput> Run();

  const Sequence& sequence() const { return sequence_; }
  const std::string& filter_name() const { return pipeline_.filter_name(); }

 private:
  ModeRunOptions OptionsOf(const MethodInfo& method) const;
  // The clip of the range, on which the method can run, with its alpha where there is one.
  Clip Load(const FrameRange& range, const MethodInfo& method) const;
  Streams TruthStreams(const MethodInfo& method) const;
  Clip LoadTruth(const MethodInfo& method) const;
  void CheckMode(const MethodInfo& method) const;
  ModeOutput RunOne(const MethodInfo& method);

  const RunRequest& request_;
  const std::vector<const MethodInfo*> methods_;
  const Pipeline pipeline_;
  const Sequence sequence_;
  const ShownFormat format_;
  const FrameRange range_;
  const std::unique_ptr<ModeDevice> device_;
  ThreadPool pool_;
};

}  // namespace warplut
