// Files of a folder whose names differ in one number.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace warplut {

struct NumberedFiles {
  std::string pattern;       // datasets/sequence/frame_pattern.h, relative to the folder
  std::vector<int> numbers;  // ascending
};

// The numbered image, .flo and .dpt files in `folder` and up to three folders below it, by pattern.
// The number is the last run of digits in the name. Hidden files and folders are skipped. Ascending
// by pattern. An Error names a folder that cannot be listed.
std::vector<NumberedFiles> FindNumberedFiles(const std::filesystem::path& folder);

}  // namespace warplut
