// Writes a sequence frame by frame, so that it can be stopped and taken up again.
#pragma once

#include <filesystem>
#include <string>

#include "datasets/sequence/sequence.h"

namespace warplut {

// A Sequence with the usual layout: lr/color/%04d.png, lr/depth/%04d.exr (Z), lr/motion/%04d.exr
// (X, Y) and hr/ alike for the references; lr/reactive/%04d.png, hr/hud/%04d.png (premultiplied),
// lr/alpha/%04d.png and hr/alpha/%04d.png; colour and HUD in .exr where linear. Linear depth from
// near to far, motion in pixels from previous to current, y down. `streams` always includes color.
// Jitter, camera and cuts are left empty.
Sequence StandardSequence(const std::string& name, int first, int count, GridSize render,
                          GridSize output, ColorSpace color_space, Streams streams, double near,
                          double far);

// Writes frames in the convention that `sequence` describes, then the manifest. The manifest comes
// last: a folder in which writing was interrupted has none. Until then <manifest>.partial holds the
// text of the manifest to be, so that frames of two different sequences never mix. Every file is
// written atomically. Not for two writers in one folder at a time; one writer may be used from
// several threads for different frames.
//
// Formats: colour, masks and layers .png (8 bit) or .exr (half); depth and motion .exr (float), or
// .png where packed.
class SequenceWriter {
 public:
  // `sequence.folder` is set to `folder`. Creates the folders. Error: `sequence` is not valid or
  // has a file type or a path used twice that cannot be written, or the folder holds another
  // sequence, finished or not.
  SequenceWriter(const std::filesystem::path& folder, Sequence sequence);

  const Sequence& sequence() const { return sequence_; }

  // Whether all files of the frame at `index` are there and can be loaded.
  bool Has(int index) const;

  // Writes the streams of the frame at `index`; the manifest, if there is one, goes first. Number,
  // jitter, camera and cut are those of the sequence, not of `frame`. Error: an image that is
  // absent or of another size, or a value that the encoding cannot hold.
  void Write(int index, const Frame& frame) const;

  // Writes the manifest. Error if a frame is missing.
  void Finish() const;

 private:
  std::filesystem::path manifest() const { return sequence_.folder / Sequence::kManifest; }
  std::filesystem::path partial() const;

  Sequence sequence_;
  std::string json_;
};

}  // namespace warplut
