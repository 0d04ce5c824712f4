// Whether what is asked for at run time is in the build.
#pragma once

#include <optional>
#include <string>

#include "runtime/configuration/choice_list.h"
#include "runtime/core/image_check.h"
#include "runtime/pipeline.h"

namespace warplut {

constexpr const char* ChoiceName(bool is_on) { return is_on ? "on" : "off"; }
constexpr const char* ChoiceName(Filter filter) { return Info(filter).name; }
template <class T>
constexpr const char* ChoiceName(T value) {
  return Name(value);
}

// Otherwise "THING is VALUE; this build contains CHOICE alone."
template <class T>
bool CheckChoice(const char* thing, const std::optional<T>& choice, T value, std::string* why) {
  if (Contains(choice, value)) return true;
  return Refuse(
      {thing, " is ", ChoiceName(value), "; this build contains ", ChoiceName(*choice), " alone."},
      why);
}

// The same for all of a list of choices (runtime/configuration/choice_list.h).
template <class List, class Configuration, class Options>
bool CheckChoices(const List& list, const Configuration& build, const Options& options,
                  std::string* why) {
  return AllChoices(list, [&](const auto& choice) {
    return choice.owner == ChoiceOwner::kFrames ||
           CheckChoice(choice.thing, build.*choice.configured, options.*choice.option, why);
  });
}

// Otherwise "This build does not contain PART."
inline bool CheckPart(const char* part, bool contained, std::string* why) {
  return contained || Refuse({"This build does not contain ", part, "."}, why);
}

}  // namespace warplut
