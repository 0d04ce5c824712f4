#include "tools/memory_size.h"

#include <fmt/format.h>

#include <charconv>

#include "datasets/error.h"

namespace warplut {

std::size_t ParseMemorySize(const std::string& text) {
  if (text.empty()) return 0;
  constexpr std::size_t kMostUnits = std::size_t{1} << 30;
  std::size_t units = 0;
  const char* end = text.data() + text.size();
  const auto [unit, error] = std::from_chars(text.data(), end, units);
  const std::string suffix(unit, end);
  const int shift = suffix == "K" ? 10 : suffix == "M" ? 20 : suffix == "G" ? 30 : 0;
  if (error != std::errc() || shift == 0 || units < 1 || units > kMostUnits) {
    throw Error(fmt::format(
        "the memory is '{}'; expected a whole number from 1 to {} and K, M or G, as 500M", text,
        kMostUnits));
  }
  return units << shift;
}

}  // namespace warplut
