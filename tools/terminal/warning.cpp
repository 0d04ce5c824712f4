#include "tools/terminal/warning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "train/ranks/ranks.h"

namespace warplut {

void Warn(const std::string& sentence) {
  if (Ranks::World().IsRoot()) WarnOfPiece(sentence);
}

void WarnOfPiece(const std::string& sentence) {
  fmt::print(stderr, "warplut: warning: {}.\n", sentence);
}

void WarnOfInfiniteColor(std::int64_t channels, const std::string& sequence) {
  WarnOfPiece(fmt::format(
      "{} channels of the linear colour of '{}' are infinite or beyond {}; above they count as "
      "that, below as 0",
      channels, sequence, kLargestHdr));
}

void WarnOfLimitedColor(const std::vector<const Clip*>& clips) {
  // The clips hold the same colour, as far as they hold it.
  std::int64_t color = 0, reference = 0;
  std::string name;
  for (const Clip* clip : clips) {
    if (clip == nullptr) continue;
    color = std::max(color, clip->limited_color);
    reference = std::max(reference, clip->limited_reference);
    name = clip->name;
  }
  if (color + reference > 0) WarnOfInfiniteColor(color + reference, name);
}

}  // namespace warplut
