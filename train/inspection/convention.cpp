#include "train/inspection/convention.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace warplut {
namespace {

const char* NameOf(StoredUnit unit) {
  switch (unit) {
    case StoredUnit::kPixels:
      return "render pixels";
    case StoredUnit::kOutputPixels:
      return "output pixels";
    case StoredUnit::kUv:
      return "uv";
    default:
      return "ndc";
  }
}

StoredUnit UnitOf(MotionUnits units) {
  switch (units) {
    case MotionUnits::kUv:
      return StoredUnit::kUv;
    case MotionUnits::kNdc:
      return StoredUnit::kNdc;
    default:
      return StoredUnit::kPixels;
  }
}

std::vector<StoredUnit> Units(const Sequence& s) {
  std::vector<StoredUnit> units = {StoredUnit::kPixels, StoredUnit::kUv, StoredUnit::kNdc};
  if (!(s.output == s.render)) units.push_back(StoredUnit::kOutputPixels);
  return units;
}

// A stored number becomes scale v + bias.
struct Decoding {
  std::array<double, 2> scale, bias;
};

std::vector<Decoding> Decodings(const MotionStream& motion, bool encoded) {
  std::vector<Decoding> decodings = {{motion.scale, motion.bias}};
  const auto add = [&](const Decoding& decoding) {
    const bool there = std::any_of(decodings.begin(), decodings.end(), [&](const Decoding& d) {
      return std::abs(d.scale[0]) == decoding.scale[0] &&
             std::abs(std::abs(d.bias[0]) - std::abs(decoding.bias[0])) < 1e-9;
    });
    if (!there) decodings.push_back(decoding);
  };
  add({{1, 1}, {0, 0}});
  if (!encoded) return decodings;
  // The codes of no motion: the middle, and those of 8 bits beside it.
  for (const double middle : {0.5, 127 / 255.0, 128 / 255.0}) {
    add({{2, 2}, {-2 * middle, -2 * middle}});
  }
  return decodings;
}

}  // namespace

std::string MotionConvention::DirectionName() const {
  if (forward) return negated ? "next-to-current" : "current-to-next";
  return negated ? "current-to-previous" : "previous-to-current";
}

std::string MotionConvention::UnitName() const {
  const bool plain = scale == std::array<double, 2>{1, 1} && bias == std::array<double, 2>{0, 0};
  if (plain) return NameOf(unit);
  return fmt::format("{} ({:.6g} v {} {:.6g})", NameOf(unit), std::abs(scale[0]),
                     bias[0] < 0 ? "-" : "+", std::abs(bias[0]));
}

std::string MotionConvention::AxesName() const { return swapped ? "y, x" : "x, y"; }
std::string MotionConvention::YName() const { return y_up ? "up" : "down"; }
std::string MotionConvention::FrameName() const {
  if (frame_offset == 0) return "its own";
  return frame_offset > 0 ? "one late" : "one early";
}

std::string JitterConvention::SignName() const {
  if (none) return "";
  if (negated_x && negated_y) return "both negated";
  if (negated_x) return "x negated";
  return negated_y ? "y negated" : "as stated";
}
std::string JitterConvention::AxesName() const {
  if (none) return "";
  return swapped ? "y, x" : "x, y";
}
std::string JitterConvention::UnitName() const { return none ? "" : NameOf(unit); }
std::string JitterConvention::FrameName() const {
  if (none) return "";
  return shift == 0 ? "its own" : fmt::format("shifted by {:+}", shift);
}

MotionConvention StatedMotion(const Sequence& sequence) {
  MotionConvention stated;
  if (!sequence.motion) return stated;
  const MotionStream& motion = *sequence.motion;
  stated.scale = motion.scale;
  stated.bias = motion.bias;
  stated.unit = UnitOf(motion.units);
  stated.forward = motion.direction == MotionDirection::kCurrentToNext;
  stated.negated = motion.direction == MotionDirection::kCurrentToPrevious;
  stated.y_up = motion.y == YAxis::kUp;
  stated.frame_offset = motion.frame_offset;
  return stated;
}

std::vector<MotionConvention> MotionCandidates(const Sequence& sequence, bool encoded) {
  std::vector<MotionConvention> candidates;
  if (!sequence.motion) return candidates;
  const MotionConvention stated = StatedMotion(sequence);
  candidates.push_back(stated);
  for (const Decoding& decoding : Decodings(*sequence.motion, encoded)) {
    for (const StoredUnit unit : Units(sequence)) {
      for (int bits = 0; bits < 16; ++bits) {
        for (int offset = -1; offset <= 1; ++offset) {
          const MotionConvention candidate = {decoding.scale,  decoding.bias,   unit,
                                              (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0,
                                              (bits & 8) != 0, offset};
          if (!(candidate == stated)) candidates.push_back(candidate);
        }
      }
    }
  }
  return candidates;
}

std::vector<JitterConvention> JitterCandidates(const Sequence& sequence) {
  std::vector<JitterConvention> candidates = {{}};
  if (sequence.jitter.empty()) return candidates;
  candidates.push_back({.none = true});
  const auto length = static_cast<int>(sequence.jitter.size());
  std::vector<int> shifts = {0};
  for (const int shift : {1, -1, 2, -2, sequence.first % length}) {
    const bool there = std::any_of(shifts.begin(), shifts.end(),
                                   [&](int other) { return (other - shift) % length == 0; });
    if (!there) shifts.push_back(shift);
  }
  double largest = 0;
  for (const Vec2& v : sequence.jitter) {
    largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
  }
  for (const StoredUnit unit : Units(sequence)) {
    const auto pixels = PixelsPer(unit, sequence.render, sequence.output);
    if (largest * std::max(pixels[0], pixels[1]) > 2) continue;
    for (const int shift : shifts) {
      for (int bits = 0; bits < 8; ++bits) {
        const JitterConvention candidate = {
            false, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, unit, shift};
        if (!(candidate == JitterConvention{})) candidates.push_back(candidate);
      }
    }
  }
  return candidates;
}

std::array<double, 2> PixelsPer(StoredUnit unit, GridSize render, GridSize output) {
  switch (unit) {
    case StoredUnit::kPixels:
      return {1, 1};
    case StoredUnit::kOutputPixels:
      return {static_cast<double>(render.width) / output.width,
              static_cast<double>(render.height) / output.height};
    case StoredUnit::kUv:
      return {static_cast<double>(render.width), static_cast<double>(render.height)};
    default:
      return {render.width / 2.0, render.height / 2.0};
  }
}

std::vector<Vec2> JitterOf(const Sequence& sequence, const JitterConvention& convention) {
  const auto length = static_cast<int>(sequence.jitter.size());
  std::vector<Vec2> cycle(sequence.jitter.size());
  if (convention.none) return cycle;
  const auto pixels = PixelsPer(convention.unit, sequence.render, sequence.output);
  for (int i = 0; i < length; ++i) {
    const int from = ((i + convention.shift) % length + length) % length;
    Vec2 v = sequence.jitter[static_cast<std::size_t>(from)];
    if (convention.swapped) std::swap(v.x, v.y);
    cycle[static_cast<std::size_t>(i)] = {(convention.negated_x ? -v.x : v.x) * pixels[0] + 0.0,
                                          (convention.negated_y ? -v.y : v.y) * pixels[1] + 0.0};
  }
  return cycle;
}

std::string DepthConvention::OrderName() const {
  return nearer_is_larger ? "nearer is larger" : "farther is larger";
}
std::string DepthConvention::CurveName() const {
  return hyperbolic ? "in 1 / view depth" : "in view depth";
}

DepthConvention StatedDepth(const DepthStream& depth) {
  return {(depth.kind == DepthKind::kReversed) != (depth.scale < 0),
          depth.kind != DepthKind::kLinear};
}

}  // namespace warplut
