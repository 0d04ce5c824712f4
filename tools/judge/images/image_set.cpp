#include "tools/judge/images/image_set.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>
#include <utility>

#include "datasets/error.h"
#include "datasets/hash.h"
#include "datasets/images/image_list.h"
#include "datasets/json_fields.h"
#include "train/metrics/displayed_color.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// `file` as seen from the folder that was given, with that folder's name in front; never absolute.
std::string RecordName(const fs::path& given, const fs::path& file) {
  const fs::path absolute = fs::weakly_canonical(given);
  const fs::path folder = fs::is_directory(absolute) ? absolute : absolute.parent_path();
  return RecordedName(
      (folder.filename() / fs::weakly_canonical(file).lexically_relative(folder)).generic_string());
}

Image LoadDisplayImage(const ListedImage& listed) {
  Image image = LoadListedImage(listed);
  if (listed.IsLinear()) return DisplayedImage(std::move(image), ColorEncoding::kLinearHdr);
  const fs::path& file = listed.file;
  if (image.channels == 2) {
    throw Error(fmt::format("{} has 2 channels; expected 1, 3 or 4.", file.string()));
  }
  image = WithoutAlpha(image);
  const auto outside = std::find_if(image.data.begin(), image.data.end(),
                                    [](float value) { return !(value >= 0 && value <= 1); });
  if (outside != image.data.end()) {
    throw Error(
        fmt::format("{} has the value {}; expected colours as displayed, in [0, 1], or a "
                    "sequence whose color_space is \"linear\".",
                    file.string(), *outside));
  }
  return image;
}

}  // namespace

std::vector<TrainImage> LoadImages(const std::vector<fs::path>& paths, int* tone_mapped,
                                   const fs::path& streams_below) {
  std::vector<TrainImage> images;
  int linear = 0;
  std::set<fs::path> seen;
  for (const fs::path& path : paths) {
    for (const ListedImage& listed : ListImages(path, streams_below)) {
      const fs::path& file = listed.file;
      if (!seen.insert(fs::weakly_canonical(file)).second) {
        throw Error(fmt::format("{} is given twice.", file.string()));
      }
      TrainImage loaded;
      loaded.image = LoadDisplayImage(listed);
      linear += listed.IsLinear() ? 1 : 0;
      loaded.record = {.name = RecordName(path, file),
                       .sha1 = Sha1OfFile(file),
                       .width = loaded.image.width,
                       .height = loaded.image.height};
      images.push_back(std::move(loaded));
    }
  }
  if (tone_mapped != nullptr) *tone_mapped = linear;
  return images;
}

std::string ToneMappedText(int tone_mapped, std::size_t images) {
  if (tone_mapped == 0) return "";
  return fmt::format(
      "{} of {} images are linear HDR; they are used as displayed, tone-mapped as eval judges.\n",
      tone_mapped, images);
}

Image DisplayedImage(Image image, ColorEncoding encoding) {
  if (encoding == ColorEncoding::kDisplay) return image;
  tbb::parallel_for(0, image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      float* pixel = &image.data[image.Index(x, y)];
      if (image.channels >= 3) {
        ToDisplay(encoding, pixel);
      } else {
        float rgb[] = {*pixel, *pixel, *pixel};
        ToDisplay(encoding, rgb);
        *pixel = rgb[0];
      }
    }
  });
  return image;
}

Image WithoutAlpha(const Image& image) {
  if (image.channels != 4) return image;
  Image rgb(image.width, image.height, 3);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    std::copy_n(&image.data[pixel * 4], 3, &rgb.data[pixel * 3]);
  }
  return rgb;
}

Image CenterCrop(const Image& image, int side) {
  const int width = side > 0 ? std::min(side, image.width) : image.width;
  const int height = side > 0 ? std::min(side, image.height) : image.height;
  const int left = (image.width - width) / 2;
  const int top = (image.height - height) / 2;
  Image crop(width, height, image.channels);
  for (int y = 0; y < height; ++y) {
    std::copy_n(&image.data[image.Index(left, top + y)],
                static_cast<std::size_t>(width) * image.channels, &crop.data[crop.Index(0, y)]);
  }
  return crop;
}

}  // namespace warplut
