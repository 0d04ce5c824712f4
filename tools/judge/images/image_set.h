// The images that a person's paths stand for, loaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/color_encoding.h"
#include "train/fit/trainer.h"

namespace warplut {

// Loads every image of every path (datasets/images/image_list.h says what a path may be), in that
// order, as displayed: linear HDR of sequences is tone-mapped, and *tone_mapped, unless null,
// receives how many images were. Each record has the file's name behind the name of the folder that
// was given, its SHA-1 and its size. An Error names the file: what LoadListedImage refuses, 2
// channels, or a value outside [0, 1] of a file that stands alone; or says that two paths give the
// same file. Alpha is dropped. Sequences are read with `streams_below` (ReadSequence).
std::vector<TrainImage> LoadImages(const std::vector<std::filesystem::path>& paths,
                                   int* tone_mapped = nullptr,
                                   const std::filesystem::path& streams_below = {});

// The sentence about images that were tone-mapped, with a newline; empty if none was.
std::string ToneMappedText(int tone_mapped, std::size_t images);

// `image` (1 or 3 channels) as a display shows it (train/metrics/displayed_color.h); grey counts as
// R = G = B.
Image DisplayedImage(Image image, ColorEncoding encoding);

// The first 3 channels of an image with 4; any other image as it is.
Image WithoutAlpha(const Image& image);

// Cuts the largest centred window of at most `side` pixels in each axis; 0 leaves the image as it
// is.
Image CenterCrop(const Image& image, int side);

}  // namespace warplut
