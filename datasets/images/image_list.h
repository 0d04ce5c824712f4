// The images that a path given by a person stands for, and the one reader of them.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "datasets/image.h"
#include "datasets/sequence/sequence.h"

namespace warplut {

// One image: of a frame of a sequence, or a file that stands alone.
struct ListedImage {
  std::filesystem::path file;
  std::shared_ptr<const Sequence> sequence = {};  // null: the file stands alone
  int index = 0;                                  // of the frame
  Streams stream = Streams::kColor;               // or kReference

  // Whether it is linear HDR, as its sequence says; a file that stands alone says nothing.
  bool IsLinear() const { return sequence && sequence->color_space == ColorSpace::kLinear; }
};

// `path` is
//   an image file                      that file;
//   a sequence.json or its folder      the references of all frames, or their colour without one;
//   another folder with image files    these (by extension; hidden files and subfolders are
//                                      skipped), in ascending order of their names as bytes;
//   a folder with none, but sequences  the images of the sequences right below it, in the order of
//                                      their folders.
// Sequences are read with `streams_below` (ReadSequence).
// Never empty: an Error names `path` if there is nothing, or if a file of a sequence is missing.
std::vector<ListedImage> ListImages(const std::filesystem::path& path,
                                    const std::filesystem::path& streams_below = {});

// The image: of a sequence R, G, B as LoadFrame reads it (its channels, size and range checked as
// the manifest says); of another file what it stores (ReadImage). Errors as those.
Image LoadListedImage(const ListedImage& listed);

}  // namespace warplut
