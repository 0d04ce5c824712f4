#include "datasets/images/image_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

bool IsImageName(const fs::path& path) {
  constexpr std::array kExtensions = {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp",
                                      ".tga", ".hdr", ".ppm", ".pgm",  ".pnm", ".webp"};
  if (path.filename().string().front() == '.') return false;
  return std::any_of(kExtensions.begin(), kExtensions.end(),
                     [&](const char* extension) { return HasExtension(path, extension); });
}

std::vector<ListedImage> ListSequence(const fs::path& path, const fs::path& streams_below) {
  const auto sequence = std::make_shared<const Sequence>(ReadSequence(path, streams_below));
  const Streams stream = sequence->reference ? Streams::kReference : Streams::kColor;
  std::vector<ListedImage> images;
  for (int index = 0; index < sequence->count; ++index) {
    for (fs::path& file : FrameFiles(*sequence, index, stream)) {
      if (!fs::is_regular_file(file)) {
        throw Error(
            fmt::format("'{}' of the sequence '{}' does not exist", file.string(), sequence->name));
      }
      images.push_back(
          {.file = std::move(file), .sequence = sequence, .index = index, .stream = stream});
    }
  }
  return images;
}

// The image files of a folder, in the order of their names.
std::vector<ListedImage> ListFiles(const fs::path& folder) {
  std::vector<ListedImage> images;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->is_regular_file() && IsImageName(it->path())) images.push_back({.file = it->path()});
  }
  if (error) throw Error(fmt::format("cannot list '{}': {}", folder.string(), error.message()));
  std::sort(images.begin(), images.end(), [](const ListedImage& a, const ListedImage& b) {
    return a.file.native() < b.file.native();
  });
  return images;
}

}  // namespace

std::vector<ListedImage> ListImages(const fs::path& path, const fs::path& streams_below) {
  if (!fs::exists(path)) throw Error(fmt::format("'{}' does not exist", path.string()));
  if (!fs::is_directory(path)) {
    if (HasExtension(path, ".json")) return ListSequence(path, streams_below);
    return {{.file = path}};
  }
  if (fs::exists(path / Sequence::kManifest)) return ListSequence(path, streams_below);
  std::vector<ListedImage> images = ListFiles(path);
  if (!images.empty()) return images;
  for (const fs::path& folder : SequencesBelow(path)) {
    for (ListedImage& image : ListSequence(folder, streams_below))
      images.push_back(std::move(image));
  }
  if (images.empty()) {
    throw Error(
        fmt::format("'{}' has no images; expected image files, a {}, or folders that "
                    "have one",
                    path.string(), Sequence::kManifest));
  }
  return images;
}

Image LoadListedImage(const ListedImage& listed) {
  if (!listed.sequence) return ReadImage(listed.file);
  Frame frame = LoadFrame(*listed.sequence, listed.index, listed.stream);
  return std::move(listed.stream == Streams::kReference ? frame.reference : frame.color);
}

}  // namespace warplut
