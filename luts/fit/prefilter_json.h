// A prefilter in the JSON files of fits and tables.
//
//   {"kind": "recursive", "side": s, "pole": z}
//   {"kind": "fir", "side": s, "taps": [t_0, t_1, ... t_reach]}
#pragma once

#include <nlohmann/json.hpp>

#include "datasets/json_fields.h"
#include "luts/prefilter.h"

namespace warplut {

// `prefilter` is valid and not none. Numbers are the shortest decimals of the floats.
nlohmann::ordered_json ToJson(const Prefilter& prefilter);

// How far the pole of a file may be from that of its side.
inline constexpr double kPoleTolerance = 1e-5;

// Reads and checks; an Error names the file, the field, what was found and what was expected.
Prefilter ReadPrefilter(JsonFields fields);

}  // namespace warplut
