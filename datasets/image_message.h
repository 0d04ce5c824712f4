// What OpenImageIO says of a failure, as a part of one sentence.
#pragma once

#include <algorithm>
#include <string>

namespace warplut {

// On one line, without the spaces at its end; a reason of our own if it is empty.
inline std::string ImageMessage(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return message.empty() ? "it is damaged or of an unknown format" : message;
}

}  // namespace warplut
