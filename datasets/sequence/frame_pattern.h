// Names of numbered files: printf patterns with one conversion, as "lr/color/%04d.png".
#pragma once

#include <string>
#include <string_view>

namespace warplut {

// Whether `pattern` is a relative path below its folder ('/' between parts, no "..", no control
// characters) with exactly one conversion %d, %Nd or %0Nd (N from 1 to 9) in it; "%%" is a percent
// sign. It may begin with up to `levels_up` parts "..". If not and `why` is given, *why ends a
// sentence that begins with the pattern: "has ...; expected ...".
bool IsFramePattern(std::string_view pattern, std::string* why = nullptr, int levels_up = 0);

// `pattern`, which IsFramePattern, with its conversion replaced by `number` >= 0.
std::string FrameFileName(std::string_view pattern, int number);

}  // namespace warplut
