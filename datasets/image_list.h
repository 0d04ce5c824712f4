// The images that a path given by a person stands for.
#pragma once

#include <filesystem>
#include <vector>

namespace warplut {

// `path` is
//   an image file                      that file;
//   a sequence.json or its folder      the reference files of all frames, or the colour files without a reference;
//   another folder                     its image files (by extension; hidden files and subfolders are skipped), in
//                                      ascending order of their names as bytes.
// Never empty: an Error names `path` if there is nothing, or if a file of the sequence is missing.
std::vector<std::filesystem::path> ListImages(const std::filesystem::path& path);

}  // namespace warplut
