// What a profile found, as tables for people, as JSON for programs, and as the banner of
// PIPELINE.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/profile/profile_search.h"
#include "tools/profile/smaller_table.h"
#include "tools/profile/tile_shares.h"
#include "tools/tables/record_table.h"

namespace warplut {

struct ProfiledSequence {
  std::string name;
  std::string sha1;  // of the manifest
  bool has_reference = true;
};

struct ProfileReport {
  std::string version;  // of the program
  std::string mode;
  std::string filter;
  double within = 0;
  std::vector<ProfiledSequence> sequences;
  std::string searched_frames;  // as on the command line; empty: all
  ProfiledPipeline full;
  ProfileResult result;
  std::vector<SmallerTable> tables;  // empty without a LUT
  bool tables_in_chosen =
      false;  // run in the chosen pipeline, else in the full one, as the chosen reads no table
  std::optional<SmallerTable> table;  // the proposed one, where the chosen pipeline reads a table
  std::string bake = {};              // the command line that makes it; empty without a fit to bake
  std::vector<TileShares> tiles;      // of each sequence, full pipeline
  TimeRatio time_by_tiles;
};

// One row: time of the full pipeline, that of the chosen one and of the method as it ships as
// shares of it, the change of SSIM, what was left out.
TextTable SummaryTable(const ProfileReport& report);

// Rows: every omission alone.
TextTable AloneTable(const ProfileReport& report);

// Rows: what was taken one after the other, the chosen pipeline on all frames, the method as it
// ships.
TextTable TogetherTable(const ProfileReport& report);

// Rows: nodes, storage and lookup.
TextTable TablesTable(const ProfileReport& report);

// Rows: sequences.
TextTable TileTable(const ProfileReport& report);

// The tables and what is to be said about them.
std::string ToText(const ProfileReport& report);

// The tables alone, but for those without a row.
std::string ToMarkdown(const ProfileReport& report);

Json ToJson(const ProfileReport& report);

// The comment of PIPELINE.h, line by line. Only the line that begins with "Measured"
// depends on measured times.
std::vector<std::string> Banner(const ProfileReport& report);

}  // namespace warplut
