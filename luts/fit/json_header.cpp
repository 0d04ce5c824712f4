#include "luts/fit/json_header.h"

#include <fmt/format.h>

#include <optional>

#include "datasets/file.h"
#include "luts/footprint_names.h"
namespace warplut {
namespace {

constexpr const char* kTapsField = "taps";

}  // namespace

int CheckHeader(JsonFields& fields, const char* format, int oldest, int newest) {
  const std::string found = fields.Text("format");
  if (found != format)
    fields.At("format").Fail(fmt::format("is \"{}\"; expected \"{}\"", found, format));
  const int found_version = fields.Integer("version");
  if (found_version < oldest || found_version > newest) {
    const std::string expected = oldest == newest
                                     ? fmt::format("{}, the version", newest)
                                     : fmt::format("{} to {}, the versions", oldest, newest);
    fields.At("version").Fail(
        fmt::format("is {}; expected {} that this program reads", found_version, expected));
  }
  return found_version;
}

void WriteFootprint(Footprint footprint, nlohmann::ordered_json& json) {
  if (footprint != Footprint::k16) json[kTapsField] = TapCount(footprint);
}

Footprint ReadFootprint(JsonFields& fields) {
  if (!fields.Has(kTapsField)) return Footprint::k16;
  const int found = fields.Integer(kTapsField);
  const std::optional<Footprint> footprint = FootprintWith(found);
  if (!footprint) {
    fields.At(kTapsField).Fail(fmt::format("is {}; expected {}", found, FootprintNames()));
  }
  return *footprint;
}

}  // namespace warplut
