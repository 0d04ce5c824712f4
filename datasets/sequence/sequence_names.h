// The words of sequence.json, for its reader and its writer.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "datasets/sequence/sequence.h"

namespace warplut {

template <class T, std::size_t n>
using Names = std::array<std::pair<T, const char*>, n>;

inline constexpr Names<ColorSpace, 2> kColorSpaces{
    {{ColorSpace::kSrgb, "srgb"}, {ColorSpace::kLinear, "linear"}}};
inline constexpr Names<Encoding, 2> kEncodings{
    {{Encoding::kFloat, "float"}, {Encoding::kRgba8Base255, "rgba8-base255"}}};
inline constexpr Names<DepthKind, 3> kDepthKinds{{{DepthKind::kLinear, "linear"},
                                                  {DepthKind::kForward, "forward"},
                                                  {DepthKind::kReversed, "reversed"}}};
inline constexpr Names<MotionUnits, 3> kMotionUnits{
    {{MotionUnits::kPixels, "pixels"}, {MotionUnits::kUv, "uv"}, {MotionUnits::kNdc, "ndc"}}};
inline constexpr Names<MotionDirection, 3> kDirections{
    {{MotionDirection::kPreviousToCurrent, "previous-to-current"},
     {MotionDirection::kCurrentToPrevious, "current-to-previous"},
     {MotionDirection::kCurrentToNext, "current-to-next"}}};
inline constexpr Names<bool, 2> kJitterIn{{{false, "excluded"}, {true, "included"}}};
inline constexpr Names<YAxis, 2> kYAxes{{{YAxis::kDown, "down"}, {YAxis::kUp, "up"}}};

// Whether the colours of a layer are multiplied by its alpha.
inline constexpr Names<AlphaKind, 2> kAlphaKinds{
    {{AlphaKind::kStraight, "straight"}, {AlphaKind::kPremultiplied, "premultiplied"}}};

inline constexpr const char* kRenderGridName = "render";
inline constexpr const char* kOutputGridName = "output";
inline constexpr const char* kJitterUnitsName = "render-pixels";

template <class T, std::size_t n>
const char* NameOf(const Names<T, n>& names, T value) {
  for (const auto& [v, name] : names) {
    if (v == value) return name;
  }
  return "";
}

}  // namespace warplut
