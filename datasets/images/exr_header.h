// The sizes in the header of an OpenEXR file.
#pragma once

#include <filesystem>

namespace warplut {

// An Error that names the file where an attribute of a header has a length that its type cannot
// have, or is longer than the file: libraries take memory of that size (up to 2 GiB) before they
// read. The same where a window has a side outside 1 to kMaxImageSide, or tiles one above 4096, as
// readers take memory for whole lines and tiles. Other faults, and files that are not
// OpenEXR, are left to the reader. Source: "The OpenEXR File Layout", OpenEXR documentation.
void CheckExrHeader(const std::filesystem::path& path);

}  // namespace warplut
