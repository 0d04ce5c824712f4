// The chunks of a PNG file.
#pragma once

#include <filesystem>

namespace warplut {

// An Error that names the file where a chunk goes beyond its end, the last one is not IEND, or a
// checksum does not fit: libraries tell that on standard error besides. The checksums are those
// before the first pixel; with `pixels` all. Files that do not begin as PNG are left to the reader.
// Source: "Portable Network Graphics Specification (Third Edition)", section 5.
void CheckPngChunks(const std::filesystem::path& path, bool pixels);

}  // namespace warplut
