// Image files, through OpenImageIO. The only file pair that knows it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/image.h"

namespace warplut {

// The largest width or height that is read: larger is refused as damaged.
inline constexpr int kMaxImageSide = 32768;

// Reads any file that OpenImageIO knows. Integer formats are scaled to [0, 1]; nothing is converted between
// colour spaces, alpha is left as stored. Width, height >= 1, 1 to 4 channels (with `channels` empty) or exactly
// the named channels in the given order. Errors (one sentence, naming the file): missing, not an image, truncated,
// side above kMaxImageSide, a channel that is not there, and with `finite` a NaN or infinite value (with its
// pixel and channel).
Image ReadImage(const std::filesystem::path& path, const std::vector<std::string>& channels = {},
                bool finite = true);

enum class PixelType : std::uint8_t { kUint8, kUint16, kHalf, kFloat };

// Writes `image` atomically; the format is that of the extension (.png, .exr, ...). Values outside [0, 1] are
// clamped for integer types, rounded to nearest. `channel_names` may be empty (R, G, B, A / Y).
void WriteImage(const std::filesystem::path& path, const Image& image, PixelType type,
                const std::vector<std::string>& channel_names = {});

}  // namespace warplut
