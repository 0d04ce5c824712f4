// The methods of the runtime: one registry for calibration, reports, benchmarks, the command line
// and the tests.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "luts/visibility.h"
#include "runtime/frame_generation.h"
#include "runtime/parameters.h"
#include "runtime/super_resolution.h"

namespace WARPLUT_PUBLIC warplut {

// Frames that a method generates: between two rendered ones (interpolation) or after the later one
// (extrapolation), on the grid of their sources.
enum class Generation : std::uint8_t { kNone, kInterpolation, kExtrapolation };

// The maker of generated frames; kRepeat and kAverage are baselines without motion.
enum class Generator : std::uint8_t { kWarped, kRepeat, kAverage };

// The camera of a generated frame, where the sequence has cameras (docs/METHODS.md): none is known,
// its own, as where each shown frame is a frame of the game's logic, or one between those of the
// rendered frames around it, as where only these are.
enum class CameraSchedule : std::uint8_t { kNone, kOfFrame, kBetween };

struct MethodInfo {
  const char* name;  // as on the command line
  const char* meaning;
  bool super_resolution;  // its output is on the output grid, from colour on the render grid
  Generation generation;
  Generator generator;
  // Motion and depth are not those of the renderer: who runs the method finds motion in the colours
  // of the frames (train/replay/optical_flow.h), and depth is 0.
  bool optical_flow;
  bool peer;               // another system: its options name a peer (runtime/peers.h)
  CameraSchedule cameras;  // kMeshProjection alone
  bool paper;              // runs with kPaperParameters, whatever was calibrated
  // Sets the choices of the method; leaves sizes, filter, formats and parameters alone. Null where
  // it does not apply.
  void (*configure_super_resolution)(SuperResolutionOptions& options);
  void (*configure_generation)(FrameGenerationOptions& options);
  // Indices of the kParameters that its passes read.
  std::span<const int> parameters;
};

// Modes (sr, i, e, isr, esr), the paper's own form of each, other systems (runtime/peers.h) and the
// baselines.
std::span<const MethodInfo> Methods();

// The method of that name, or null.
const MethodInfo* FindMethod(std::string_view name);

}  // namespace warplut
