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

// What a file says of itself; no pixel is read.
struct ImageInfo {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  // names: R, G, B, A, Y, Z, layer.R, ...
  int bits = 0;                       // of a stored value, the first channel's
  bool integer = false;               // integers

  bool operator==(const ImageInfo&) const = default;
};

// Describes the part of the file that has these channels, the first part if none are named. Any
// number of channels. Errors as ReadImage, as far as the header shows them.
ImageInfo ReadImageInfo(const std::filesystem::path& path,
                        const std::vector<std::string>& channels = {});

// One part of a file, as its header says.
struct ImagePart {
  std::string name;  // empty: it has none
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<std::string> types;  // of each channel: "half", "float", "uint", "uint8", ...
};

// All parts of a file. Errors as ReadImageInfo; deep data and sizes are not refused.
std::vector<ImagePart> ReadImageParts(const std::filesystem::path& path);

// The values that a caller takes; kNumbers are all but NaN.
enum class Values : std::uint8_t { kFinite, kNumbers, kAll };

// Reads any file that OpenImageIO knows, and .flo (datasets/images/flo_file.h); docs/FORMATS.md has
// the table of what is read of OpenEXR. Integers are scaled to [0, 1], but those of OpenEXR (32
// bits) are read as the numbers that they are; nothing is converted between colour spaces, alpha is
// left as stored. The image is the display window; the data window may be larger.
//
// Width, height >= 1. With `channels` empty all 1 to 4 channels, R, G, B, A first; otherwise
// exactly the named channels in the given order, all of one part of the file: the first that has
// them. A channel has the name that the file gives it, with or without PART. before it; where none
// has it, a channel that has it in other case, if there is just one.
//
// Errors (one sentence, naming the file): missing, not an image, truncated, side above
// kMaxImageSide, deep or volume data, a data window that lacks a part of the display window, a
// channel that is not there, and a value that is not accepted (with its pixel and channel).
Image ReadImage(const std::filesystem::path& path, const std::vector<std::string>& channels = {},
                Values accepted = Values::kFinite);

enum class PixelType : std::uint8_t { kUint8, kUint16, kHalf, kFloat };

// Writes `image` (1 to 4 channels) atomically; the format is that of the extension, .png or .exr.
// Values outside [0, 1] are clamped for integer types, rounded to nearest. `channel_names` may be
// empty (Y; Y, A; R, G, B; R, G, B, A). The same image gives the same bytes. An Error names `path`:
// another extension, a type that the format lacks, NaN for an integer type, a finite value above
// the largest half for kHalf, or anything that WriteAtomically reports.
void WriteImage(const std::filesystem::path& path, const Image& image, PixelType type,
                const std::vector<std::string>& channel_names = {});

}  // namespace warplut
