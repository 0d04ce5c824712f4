// The report: which sections there are, and how they are made one after the other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

struct ReportSectionInfo {
  const char* id;
  double seconds, quick_seconds;  // of wall time that it has
  ReportSection (*make)(const ReportInputs& inputs);
  bool shared = false;  // all ranks make it together; else the root does, while the others rest
};

// In the order of the page.
std::span<const ReportSectionInfo> ReportSections();

struct ReportOptions {
  std::filesystem::path folder;
  bool quick = false;
  std::vector<std::string> sequences;  // empty: the built-in scenes
  std::string streams_below;           // ReadSequence; empty: below their manifests' folders
  std::string lut;                     // empty: the fits that ship
  int threads = 0;                     // at most; 0: one per core
  std::uint64_t seed = 1;
  std::vector<std::string> sections;  // ids; empty: all
  std::string command_line;

  bool IsValid(std::string* why) const;
};

struct ReportOutcome {
  struct Part {
    std::string id;
    double seconds = 0;
    std::string failure = {};  // empty: it was made
    std::size_t left_out = 0;  // sentences of what failed or was left out inside it
  };
  std::vector<Part> parts;
  double seconds = 0;
};

// A collective call of Ranks::World(): ranks share the frames that are rendered and the sections
// that are `shared`; all that is timed by the clock is made by the root, which alone writes and
// tells.
// Makes the sections and writes them (report_files.h) into the folder, with the scenes that it
// renders and the fits that ship beside them. A section that fails is told on the page, and the
// rest goes on. An Error if gnuplot is missing, the inputs cannot be had, a file cannot be written,
// or the program was interrupted: then the page is as it was before.
ReportOutcome MakeReport(const ReportOptions& options);

}  // namespace warplut
