// Reads a table from any of its file formats.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "luts/quantize/baked_table.h"

namespace warplut {

struct LoadedTable {
  std::string name;             // of the fit; for an EXR the file's name without extension
  BakedTable table;             // checked (CheckTable)
  std::optional<double> scale;  // upscale factor it was fitted for; an EXR does not say
};

// Whether the file is a fit, which can be baked; false for any other that can be read. Errors as
// LoadTable where it is no JSON that it should be.
bool IsFit(const std::filesystem::path& path);

// Reads
//   .json  a fit (format "warplut-fit"), quantised to `format`; or a baked table ("warplut-table"),
//          as it is stored;
//   .exr   the released layout (released_layout.h), resampled from offsets i / 31 to i / 32
//          (Resample) and quantised to `format`.
// Anything else, and a file that breaks the contract, is an Error that names the file, what was
// found and what was expected.
LoadedTable LoadTable(const std::filesystem::path& path, TableFormat format = TableFormat::kI16);

}  // namespace warplut
