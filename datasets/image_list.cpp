#include "datasets/image_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "datasets/error.h"
#include "datasets/sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

bool IsImageName(const fs::path& path) {
  constexpr std::array kExtensions = {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp",
                                      ".tga", ".hdr", ".ppm", ".pgm",  ".pnm", ".webp"};
  if (path.filename().string().front() == '.') return false;
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::vector<fs::path> ListSequence(const fs::path& path) {
  const Sequence sequence = ReadSequence(path);
  const Streams stream = sequence.reference ? Streams::kReference : Streams::kColor;
  std::vector<fs::path> images;
  for (int index = 0; index < sequence.count; ++index) {
    for (fs::path& file : FrameFiles(sequence, index, stream)) {
      if (!fs::is_regular_file(file)) {
        throw Error(
            fmt::format("'{}' of the sequence '{}' does not exist", file.string(), sequence.name));
      }
      images.push_back(std::move(file));
    }
  }
  return images;
}

}  // namespace

std::vector<fs::path> ListImages(const fs::path& path) {
  if (!fs::exists(path)) throw Error(fmt::format("'{}' does not exist", path.string()));
  if (!fs::is_directory(path)) {
    if (path.extension() == ".json") return ListSequence(path);
    return {path};
  }
  if (fs::exists(path / Sequence::kManifest)) return ListSequence(path);
  std::vector<fs::path> images;
  std::error_code error;
  for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
    if (it->is_regular_file() && IsImageName(it->path())) images.push_back(it->path());
  }
  if (error) throw Error(fmt::format("cannot list '{}': {}", path.string(), error.message()));
  if (images.empty()) {
    throw Error(fmt::format("'{}' has no images; expected image files or a {}", path.string(),
                            Sequence::kManifest));
  }
  std::sort(images.begin(), images.end(),
            [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
  return images;
}

}  // namespace warplut
