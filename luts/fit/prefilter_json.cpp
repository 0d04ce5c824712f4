#include "luts/fit/prefilter_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace warplut {
namespace {

constexpr std::array<std::pair<PrefilterKind, const char*>, 2> kKinds = {
    {{PrefilterKind::kRecursive, Name(PrefilterKind::kRecursive)},
     {PrefilterKind::kFir, Name(PrefilterKind::kFir)}}};

}  // namespace

nlohmann::ordered_json ToJson(const Prefilter& prefilter) {
  nlohmann::ordered_json json;
  json["kind"] = Name(prefilter.kind);
  json["side"] = Decimal(prefilter.side);
  if (prefilter.kind == PrefilterKind::kRecursive) {
    json["pole"] = Decimal(static_cast<float>(PoleOfSide(static_cast<double>(prefilter.side))));
    return json;
  }
  nlohmann::ordered_json& taps = json["taps"] = nlohmann::ordered_json::array();
  for (int j = 0; j <= prefilter.reach; ++j) taps.push_back(Decimal(prefilter.taps[j]));
  return json;
}

Prefilter ReadPrefilter(JsonFields fields) {
  Prefilter prefilter;
  prefilter.kind = fields.OneOf("kind", kKinds);
  prefilter.side = static_cast<float>(fields.Number("side"));
  if (prefilter.kind == PrefilterKind::kRecursive) {
    const double pole = fields.Number("pole");
    if (!(pole > -1 && pole < 0)) {
      fields.At("pole").Fail(
          fmt::format("is {}; expected a number in (-1, 0), inside the unit circle", pole));
    }
    const double expected = PoleOfSide(static_cast<double>(prefilter.side));
    if (!(std::abs(pole - expected) <= kPoleTolerance)) {
      fields.At("pole").Fail(fmt::format("is {}; expected {:.6f}, the pole of side {}", pole,
                                         expected, prefilter.side));
    }
  } else {
    const JsonPlace place = fields.At("taps");
    const nlohmann::json& taps = place.Array(fields.Take("taps"));
    if (taps.size() < 2 || taps.size() > kLargestFirReach + 1) {
      place.Fail(
          fmt::format("has {} numbers; expected 2 to {}: the middle tap and those to one side",
                      taps.size(), kLargestFirReach + 1));
    }
    prefilter.reach = static_cast<int>(taps.size()) - 1;
    for (std::size_t j = 0; j < taps.size(); ++j) {
      prefilter.taps[j] = static_cast<float>(place.Element(j).Number(taps[j]));
    }
  }
  const char* why = nullptr;
  if (!IsValid(prefilter, &why))
    fields.At("kind").Fail(fmt::format("is of a prefilter that {}", why));
  fields.Finish();
  return prefilter;
}

}  // namespace warplut
