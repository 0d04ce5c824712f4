// Refusals of image files, in one sentence each.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "datasets/error.h"

namespace warplut {

// The message of OpenImageIO for a failure, on one line, without the spaces at its end. One of our
// own if it is empty.
inline std::string ImageMessage(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return message.empty() ? "it is damaged or of an unknown format" : message;
}

// Throws an Error that names the file.
[[noreturn]] inline void RefuseImage(const std::filesystem::path& path, const std::string& reason) {
  throw Error("cannot read the image '" + path.string() + "': " + reason);
}

}  // namespace warplut
