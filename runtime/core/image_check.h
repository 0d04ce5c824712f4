// Whether images are what a pass takes. Each check fills *why (if not null) with one sentence that
// begins with the name and tells what was found and what was expected.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "runtime/image_view.h"

namespace warplut {

// Puts the sentence, whose parts follow each other, into *why (if not null); false.
bool Refuse(std::initializer_list<std::string_view> sentence, std::string* why);

// "WIDTH x HEIGHT".
std::string SizeName(int width, int height);

// An image with data, of this size, in rows of whole channels that hold its width: RGBA8, RGBA16F
// or RGBA32F.
bool CheckColor(const char* name, const ImageView& image, int width, int height, std::string* why);

// The same in R32F.
bool CheckDepth(const char* name, const ImageView& image, int width, int height, std::string* why);

// The same for motion vectors.
bool CheckMotion(const char* name, const MotionView& motion, int width, int height,
                 std::string* why);

}  // namespace warplut
