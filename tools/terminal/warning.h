// What a command tells on standard error and goes on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "train/replay/clip.h"

namespace warplut {

// Prints a sentence on standard error, as a warning: what every rank sees, from the root.
void Warn(const std::string& sentence);

// The same for a piece of the work, which its owner alone sees.
void WarnOfPiece(const std::string& sentence);

// One line on so many channels of linear colour.
void WarnOfInfiniteColor(std::int64_t channels, const std::string& sequence);

// The same where channels of linear colour were limited (Clip::limited_color): how many there are
// in the clips, all of the same frames; nulls are skipped.
void WarnOfLimitedColor(const std::vector<const Clip*>& clips);

}  // namespace warplut
