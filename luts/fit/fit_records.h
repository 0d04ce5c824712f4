// The records of a fit as JSON: the same in fits and in the provenance of baked tables.
#pragma once

#include <nlohmann/json.hpp>

#include "luts/fit/fit.h"

namespace warplut {

inline void to_json(nlohmann::ordered_json& json, const FitData& d) {
  json = {{"name", d.name}, {"sha1", d.sha1}, {"width", d.width}, {"height", d.height}};
}

inline void to_json(nlohmann::ordered_json& json, const FitScore& s) {
  json = {{"filter", s.filter}, {"warps", s.warps}, {"offsets", s.offsets}, {"ssim", s.ssim}};
}

}  // namespace warplut
