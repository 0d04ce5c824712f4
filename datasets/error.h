// The one exception of the offline tools: bad input or a failed operation, told in one sentence
// that names the thing and what was expected. The runtime does not use it.
#pragma once

#include <stdexcept>
#include <string>

namespace warplut {

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace warplut
