#include "tools/report/sections/hardware_section.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#include "runtime/warp.h"
#include "tools/report/process.h"

namespace warplut {
namespace {

constexpr const char* kUnknown = "unknown";

// The value of the first line "KEY : VALUE" of /proc/cpuinfo.
std::string ProcessorField(const std::string& key) {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return kUnknown;
}

std::string MemoryText() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || size <= 0) return kUnknown;
  return fmt::format("{:.1f} GB", 1e-9 * static_cast<double>(pages) * static_cast<double>(size));
}

std::string SystemText() {
  utsname names{};
  if (uname(&names) != 0) return kUnknown;
  return fmt::format("{} {}, {}", names.sysname, names.release, names.machine);
}

std::string GnuplotText() {
  std::string version = RunProcess({"gnuplot", "--version"}, "").out;
  while (!version.empty() && version.back() == '\n') version.pop_back();
  return version.empty() ? kUnknown : version;
}

std::string CompilerText() {
#ifdef __clang__
  return fmt::format("clang {}", __clang_version__);
#else
  return fmt::format("gcc {}", __VERSION__);
#endif
}

std::string SequencesText(const std::vector<ReportClip>& clips) {
  std::string text;
  for (const ReportClip& clip : clips) {
    text +=
        fmt::format("{}{} ({} x {} from {} x {}, {} frames)", text.empty() ? "" : "; ", clip.name,
                    clip.dense.output.width, clip.dense.output.height, clip.dense.render.width,
                    clip.dense.render.height, clip.dense.frames.size());
  }
  return text.empty() ? "none" : text;
}

}  // namespace

ReportSection HardwareSection(const ReportInputs& inputs) {
  ReportSection section{.id = "hardware", .title = "Hardware, versions, options"};
  section.tables.push_back(
      {.id = "hardware",
       .caption = "What this report was made with",
       .table = {
           .header = {"what", "value"},
           .rows = {{"processor", ProcessorField("model name")},
                    {"cores", fmt::format("{}", std::thread::hardware_concurrency())},
                    {"memory", MemoryText()},
                    {"system", SystemText()},
                    {"instruction set of the runtime", WarpTarget()},
                    {"compiler", CompilerText()},
                    {"build", WARPLUT_BUILD_TYPE},
                    {"warplut", WARPLUT_VERSION},
                    {"libraries", WARPLUT_LIBRARIES},
                    {"gnuplot", GnuplotText()},
                    {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)))},
                    {"command", inputs.command_line},
                    {"effort", inputs.quick ? "quick" : "full"},
                    {"seed", fmt::format("{}", inputs.seed)},
                    {"threads", inputs.threads > 0 ? fmt::format("{}", inputs.threads) : "all"},
                    {"table of repeated warps", inputs.warp_lut.name},
                    {"table of the pipeline", inputs.pipeline_lut.name},
                    {"sequences", SequencesText(inputs.clips)},
                    {"sequences, second resolution", SequencesText(inputs.larger_clips)}}}});
  return section;
}

}  // namespace warplut
