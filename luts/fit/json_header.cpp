#include "luts/fit/json_header.h"

#include <fmt/format.h>

namespace warplut {

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

}  // namespace warplut
