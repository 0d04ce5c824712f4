// What the JSON files of luts/ have in common: a size limit, a format name and a version.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/json_fields.h"

namespace warplut {

inline constexpr std::size_t kMaxJsonBytes = std::size_t{16} << 20;

inline constexpr const char* kFitFormat = "warplut-fit";
inline constexpr const char* kTableFormat = "warplut-table";
inline constexpr int kTableVersion = 1;

// Parses a file of at most kMaxJsonBytes; an Error names it.
nlohmann::json ReadJson(const std::filesystem::path& path);

// Takes the fields "format" and "version"; an Error says what was found and what was expected.
void CheckHeader(JsonFields& fields, const char* format, int version);

}  // namespace warplut
