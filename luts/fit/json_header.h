// Common parts of the JSON files of luts/: a format name and a version.
#pragma once

#include "datasets/json_fields.h"
#include "luts/contract.h"

namespace warplut {

inline constexpr const char* kFitFormat = "warplut-fit";
inline constexpr const char* kTableFormat = "warplut-table";
// The field "ended" of a fit that a time limit cut; other fits have none.
inline constexpr const char* kCutFit = "time limit";
inline constexpr int kTableVersion = 2;  // version 1 has neither prefilter nor taps

// Takes the fields "format" and "version" and returns the version, in [oldest, newest]; an Error
// says what was found and what was expected.
int CheckHeader(JsonFields& fields, const char* format, int oldest, int newest);
inline void CheckHeader(JsonFields& fields, const char* format, int version) {
  CheckHeader(fields, format, version, version);
}

// The field "taps", written where it is not 16, and read back: 16 where it is absent. An Error says
// what was found and what was expected.
void WriteFootprint(Footprint footprint, nlohmann::ordered_json& json);
Footprint ReadFootprint(JsonFields& fields);

}  // namespace warplut
