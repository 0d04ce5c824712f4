#include "luts/json_header.h"

#include <fmt/format.h>

#include "datasets/file.h"

namespace warplut {

nlohmann::json ReadJson(const std::filesystem::path& path) {
  return ParseJson(ReadFile(path, kMaxJsonBytes), path.string());
}

void CheckHeader(JsonFields& fields, const char* format, int version) {
  const std::string found = fields.Text("format");
  if (found != format)
    fields.At("format").Fail(fmt::format("is \"{}\"; expected \"{}\"", found, format));
  const int found_version = fields.Integer("version");
  if (found_version != version) {
    fields.At("version").Fail(fmt::format("is {}; expected {}, the version that this program reads",
                                          found_version, version));
  }
}

}  // namespace warplut
