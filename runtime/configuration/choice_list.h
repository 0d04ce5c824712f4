// The choices of the pipeline, one entry each: what checks, copies or writes them walks these
// lists.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include "runtime/frame_generation.h"
#include "runtime/pipeline_configuration.h"
#include "runtime/super_resolution.h"

namespace warplut {

// Who decides: the method (runtime/method.h), who calls it, or the format of the frames that it is
// given.
enum class ChoiceOwner : std::uint8_t { kMethod, kCaller, kFrames };

// A member of the configuration and, by the same name, of the options.
template <class Options, class Configuration, class T>
struct Choice {
  const char* member;
  ChoiceOwner owner;
  std::optional<T> Configuration::*configured;
  T Options::*option;  // null for kFrames
  const char* thing;   // at the beginning of a sentence; null for kFrames
};
template <class Options, class Configuration, class T>
Choice(const char*, ChoiceOwner, std::optional<T> Configuration::*, T Options::*, const char*)
    -> Choice<Options, Configuration, T>;

// In the order of the members.
inline constexpr auto kSrChoices = [] {
  using enum ChoiceOwner;
  using C = SuperResolutionConfiguration;
  using O = SuperResolutionOptions;
  using FrameFormat = Choice<O, C, PixelFormat>;
  return std::tuple{
      Choice{"form", kMethod, &C::form, &O::form, "The form"},
      Choice{"history", kMethod, &C::history, &O::history, "The history"},
      Choice{"clamp", kMethod, &C::clamp, &O::clamp, "The clamp"},
      Choice{"depth", kMethod, &C::depth, &O::depth, "The depth measure"},
      Choice{"motion", kMethod, &C::motion, &O::motion, "The motion"},
      Choice{"motion_filter", kCaller, &C::motion_filter, &O::motion_filter, "The motion filter"},
      Choice{"current", kMethod, &C::current, &O::current, "The current frame"},
      Choice{"history_format", kCaller, &C::history_format, &O::history_format,
             "The history format"},
      FrameFormat{"color_format", kFrames, &C::color_format, nullptr, nullptr},
      FrameFormat{"output_format", kFrames, &C::output_format, nullptr, nullptr},
      Choice{"encoding", kCaller, &C::encoding, &O::encoding, "The encoding"},
  };
}();

inline constexpr auto kGenerationChoices = [] {
  using enum ChoiceOwner;
  using C = FrameGenerationConfiguration;
  using O = FrameGenerationOptions;
  using FrameFormat = Choice<O, C, PixelFormat>;
  return std::tuple{
      Choice{"motion_model", kMethod, &C::motion_model, &O::motion_model, "The motion model"},
      Choice{"splat", kMethod, &C::splat, &O::splat, "Splatting"},
      Choice{"refine", kMethod, &C::refine, &O::refine, "Refinement"},
      Choice{"fill", kMethod, &C::fill, &O::fill, "The fill"},
      Choice{"depth", kMethod, &C::depth, &O::depth, "The depth measure"},
      Choice{"brightness_gate", kMethod, &C::brightness_gate, &O::brightness_gate,
             "The brightness gate"},
      Choice{"motion_filter", kCaller, &C::motion_filter, &O::motion_filter, "The motion filter"},
      FrameFormat{"color_format", kFrames, &C::color_format, nullptr, nullptr},
      FrameFormat{"output_format", kFrames, &C::output_format, nullptr, nullptr},
      Choice{"encoding", kCaller, &C::encoding, &O::encoding, "The encoding"},
  };
}();

// Whether visit(choice) is true for all of a list, in its order; ends at the first that is not.
template <class... Choices, class Visit>
constexpr bool AllChoices(const std::tuple<Choices...>& list, const Visit& visit) {
  return std::apply([&](const Choices&... choice) { return (visit(choice) && ...); }, list);
}

// Calls visit(choice) for all of a list, in its order.
template <class... Choices, class Visit>
constexpr void ForEachChoice(const std::tuple<Choices...>& list, const Visit& visit) {
  std::apply([&](const Choices&... choice) { (visit(choice), ...); }, list);
}

// Every member has an entry: they are of one byte each, with another that says whether there is a
// value.
template <class... Options, class... Configurations, class... T>
constexpr std::size_t ListedBytes(
    const std::tuple<Choice<Options, Configurations, T>...>& /*list*/) {
  return (sizeof(std::optional<T>) + ...);
}
static_assert(ListedBytes(kSrChoices) == sizeof(SuperResolutionConfiguration));
static_assert(ListedBytes(kGenerationChoices) == sizeof(FrameGenerationConfiguration));

}  // namespace warplut
