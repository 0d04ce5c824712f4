// The storage formats of tables, by the names that command lines use.
#pragma once

#include <string>
#include <vector>

#include "luts/contract.h"

namespace warplut {

inline constexpr TableFormat kTableFormats[] = {TableFormat::kI16, TableFormat::kF16,
                                                TableFormat::kI8, TableFormat::kF32};

inline std::vector<std::string> TableFormatNames() {
  std::vector<std::string> names;
  for (const TableFormat format : kTableFormats) names.emplace_back(Name(format));
  return names;
}

// The format of one of TableFormatNames().
inline TableFormat TableFormatOf(const std::string& name) {
  TableFormat found = kTableFormats[0];
  for (const TableFormat format : kTableFormats) {
    if (name == Name(format)) found = format;
  }
  return found;
}

}  // namespace warplut
