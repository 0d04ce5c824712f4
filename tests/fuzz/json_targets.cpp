// Targets that read JSON: a value that is accepted is written, and read back to the same text.
#include "datasets/file.h"
#include "datasets/sequence/sequence.h"
#include "luts/bake/table_io.h"
#include "luts/fit/fit.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "train/replay/parameters_file.h"

namespace warplut {

bool FuzzManifest(std::string_view bytes) {
  const auto path = FuzzFile("sequence.json", bytes);
  Sequence sequence;
  if (!Accepts([&] { sequence = ReadSequence(path); })) return false;
  const std::string text = SequenceJson(sequence);
  const Sequence again = ReadSequence(FuzzFile("again.json", text));
  Require(SequenceJson(again) == text, "a manifest changes when it is written and read");
  const Streams all = AvailableStreams(sequence);
  for (const int index : {0, sequence.count - 1}) {
    for (const auto& file : FrameFiles(sequence, index, all)) {
      const auto inside = file.lexically_normal().lexically_relative(sequence.folder);
      Require(!inside.empty() && *inside.begin() != "..", "a stream leaves the folder");
    }
  }
  return true;
}

bool FuzzFit(std::string_view bytes) {
  const auto path = FuzzFile("fit.json", bytes);
  Fit fit;
  if (!Accepts([&] { fit = ReadFit(path); })) return false;
  const auto written = FuzzFolder() / "written.json";
  WriteFit(written, fit);
  const std::string text = ReadFile(written);
  WriteFit(written, ReadFit(written));
  Require(ReadFile(written) == text, "a fit changes when it is written and read");
  // The table of one fit in eight, as it takes a second under sanitizers; weights may be beyond the
  // format.
  if (bytes.size() % 8 == 0) Accepts([&] { LoadTable(path); });
  return true;
}

bool FuzzParameters(std::string_view bytes) {
  const auto path = FuzzFile("parameters.json", bytes);
  Parameters parameters;
  if (!Accepts([&] { parameters = ReadParameters(path); })) return false;
  const std::string text = ParametersJson(parameters, "");
  const Parameters again = ReadParameters(FuzzFile("again.json", text));
  Require(ParametersJson(again, "") == text, "parameters change when they are written and read");
  return true;
}

bool FuzzTableJson(std::string_view bytes) {
  const auto path = FuzzFile("table.json", bytes);
  return Accepts([&] { LoadTable(path); });
}

}  // namespace warplut
