// Shown frames as files.
#pragma once

#include <filesystem>
#include <string>

#include "datasets/image.h"
#include "runtime/color_encoding.h"
#include "train/replay/mode_run.h"

namespace warplut {

enum class ShownFormat : std::uint8_t { kPng, kExr };

// The name of a frame shown at `time`, counted from the frame that has the number `first`:
// "0011.png" where it falls on a number, else the number before it and the thousandths after it,
// "0010_500.png". In the order of names is in the order of time up to 9999.
std::string ShownFileName(int first, double time, ShownFormat format);

// Writes it into `folder`, atomically: 8-bit .png or half-float .exr, R, G, B, and A where `alpha`
// is given: 1 channel of the frame's size. The frame is premultiplied by it then; so is an .exr,
// and a .png is straight. An Error names the file; one frame of a linear sequence as .png is such
// an error, as it does not fit into [0, 1].
void WriteShownFrame(const std::filesystem::path& folder, int first, const ShownFrame& shown,
                     ColorEncoding encoding, ShownFormat format, const Image* alpha = nullptr);

}  // namespace warplut
