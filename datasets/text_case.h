// Text in one case, to compare names that people write in either.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace warplut {

// ASCII letters in lower case; other bytes stay.
inline std::string LowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
  });
  return text;
}

}  // namespace warplut
