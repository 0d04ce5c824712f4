// The images that a person's paths stand for, loaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "train/fit/trainer.h"

namespace warplut {

// Loads every image of every path (datasets/image_list.h says what a path may be), in that order.
// Each record has the file's name behind the name of the folder that was given, its SHA-1 and its
// size. An Error names the file: what ReadImage refuses, 2 channels, or a value outside [0, 1]; or
// says that two paths give the same file. Alpha is dropped.
std::vector<TrainImage> LoadImages(const std::vector<std::filesystem::path>& paths);

// The first 3 channels of an image with 4; any other image as it is.
Image WithoutAlpha(const Image& image);

// Cuts the largest centred window of at most `side` pixels in each axis; 0 leaves the image as it is.
Image CenterCrop(const Image& image, int side);

}  // namespace warplut
