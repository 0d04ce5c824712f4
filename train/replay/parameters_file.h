// Calibrated parameters as a file: PARAMS.json, the seam between calibration and the pipeline.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/parameters.h"

namespace warplut {

inline constexpr const char* kParametersFormat = "warplut-parameters";
inline constexpr int kParametersVersion = 1;

// Reads "format": "warplut-parameters", "version": 1, "parameters": {name: value, ...}; parameters
// that are not named keep their defaults; a calibration's report beside them is passed over. Error:
// names the file, the field, what was found and expected.
Parameters ReadParameters(const std::filesystem::path& path);

// The same object as text with the calibration's report (a JSON object as text, or empty) under
// "calibration". A pure function: the same parameters give the same bytes, and ReadParameters gives
// the same floats back. Error: a parameter out of its range, a report that is no JSON object.
std::string ParametersJson(const Parameters& parameters, const std::string& calibration_json);

}  // namespace warplut
