// The methods that the runtime offers: one registry that calibration, reports, benchmarks, the command line and the tests walk.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "luts/visibility.h"
#include "runtime/frame_generation.h"
#include "runtime/parameters.h"
#include "runtime/super_resolution.h"

namespace WARPLUT_PUBLIC warplut {

// What a method makes of rendered frames. Generated frames lie between two rendered ones (interpolation) or after the later one
// (extrapolation), on the grid of their sources.
enum class Generation : std::uint8_t { kNone, kInterpolation, kExtrapolation };

// How a generated frame is made; kRepeat and kAverage are baselines that know no motion.
enum class Generator : std::uint8_t { kWarped, kRepeat, kAverage };

struct MethodInfo {
  const char* name;  // as on the command line
  const char* meaning;
  bool super_resolution;  // its output is on the output grid, from colour on the render grid
  Generation generation;
  Generator generator;
  bool paper;  // runs with kPaperParameters, whatever was calibrated
  // Sets what the method asks for and leaves sizes, filter, formats and parameters alone. Null where it does not apply.
  void (*configure_super_resolution)(SuperResolutionOptions& options);
  void (*configure_generation)(FrameGenerationOptions& options);
  // Which of kParameters its passes read, as indices.
  std::span<const int> parameters;
};

// Modes (sr, i, e, isr, esr), the paper's own form of each, and the baselines.
std::span<const MethodInfo> Methods();

// The method of that name, or null.
const MethodInfo* FindMethod(std::string_view name);

}  // namespace warplut
