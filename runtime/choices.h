// Choices of the passes: made by the options at run time, or by a PipelineConfiguration when the
// runtime is compiled.
#pragma once

#include <cstdint>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

// The form in which new samples enter the history (runtime/super_resolution.h).
enum class HistoryForm : std::uint8_t { kSample, kResidual, kAdaptive };

// The colour box that limits the history.
enum class ColorClamp : std::uint8_t { kNone, kBox, kVariance };

// The source of motion and depth of an output pixel.
enum class MotionUpsampling : std::uint8_t {
  kNearest,    // the motion of the nearest sample
  kDilated,    // that of the nearest surface among 3 x 3 samples
  kEdgeAware,  // bilinear inside surfaces, dilated at their edges
  kStatic,     // none: neither motion nor depth is read, nothing is warped
};

// The interpolation of the current frame alone.
enum class CurrentFrame : std::uint8_t { kBilinear, kBicubic };

// The path of a pixel between frames (runtime/frame_generation.h).
enum class MotionModel : std::uint8_t {
  kLinear,       // at the speed between frames 0 and 1
  kQuadratic,    // uniformly accelerated on the screen
  kPerspective,  // uniformly accelerated in homogeneous coordinates, by depth
};

enum class DisocclusionFill : std::uint8_t {
  kOwnMotion,   // frame 1 at the motion that its own pixel there has (Mob-FGSR)
  kBackground,  // the motion of the farthest of the first splatted pixels in 8 directions
  kNone,        // frame 1 as it is
};

// Names of the choices, for sentences and tables.
constexpr const char* Name(HistoryForm value) {
  switch (value) {
    case HistoryForm::kSample:
      return "sample";
    case HistoryForm::kResidual:
      return "residual";
    case HistoryForm::kAdaptive:
      return "adaptive";
  }
  return "";
}

constexpr const char* Name(ColorClamp value) {
  switch (value) {
    case ColorClamp::kNone:
      return "none";
    case ColorClamp::kBox:
      return "box";
    case ColorClamp::kVariance:
      return "variance";
  }
  return "";
}

constexpr const char* Name(MotionUpsampling value) {
  switch (value) {
    case MotionUpsampling::kNearest:
      return "nearest";
    case MotionUpsampling::kDilated:
      return "dilated";
    case MotionUpsampling::kEdgeAware:
      return "edge-aware";
    case MotionUpsampling::kStatic:
      return "static";
  }
  return "";
}

constexpr const char* Name(CurrentFrame value) {
  switch (value) {
    case CurrentFrame::kBilinear:
      return "bilinear";
    case CurrentFrame::kBicubic:
      return "bicubic";
  }
  return "";
}

constexpr const char* Name(MotionModel value) {
  switch (value) {
    case MotionModel::kLinear:
      return "linear";
    case MotionModel::kQuadratic:
      return "quadratic";
    case MotionModel::kPerspective:
      return "perspective";
  }
  return "";
}

constexpr const char* Name(DisocclusionFill value) {
  switch (value) {
    case DisocclusionFill::kOwnMotion:
      return "own motion";
    case DisocclusionFill::kBackground:
      return "background";
    case DisocclusionFill::kNone:
      return "none";
  }
  return "";
}

}  // namespace warplut
