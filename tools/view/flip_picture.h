// Pictures that change between two images: animated PNG, which browsers and most viewers play.
#pragma once

#include <string>
#include <string_view>

namespace warplut {

// The bytes of an animated PNG that shows two PNG files of one size and type in turns, each for
// `milliseconds` (1 to 65535), without end. Programs that know no animation show the first. An
// Error says that one is no PNG, or that they differ in size or type.
std::string FlipPicture(std::string_view first, std::string_view second, int milliseconds);

}  // namespace warplut
