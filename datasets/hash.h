// SHA-1 (FIPS 180-4), to name which bytes a result was made from. Not for security.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace warplut {

// 40 lower-case hexadecimal digits.
std::string Sha1(std::string_view bytes);

// Sha1 of a file's bytes, read in pieces. An Error names `path` if it cannot be read.
std::string Sha1OfFile(const std::filesystem::path& path);

}  // namespace warplut
