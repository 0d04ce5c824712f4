#include "tests/stability/cases/gates/gate_depth.h"
#include "tests/stability/cases/gates/gate_width.h"

namespace warplut {
namespace {

constexpr StabilityCase GateCase(const char* name, const char* required,
                                 StabilityResult (*run)(StabilityEffort),
                                 const char* failing = nullptr) {
  return {.group = "gates", .name = name, .required = required, .run = run, .failing = failing};
}

constexpr const char* kDepthRequired =
    "neighbouring codes pass the default T_D up to the far plane, 1e5 for a near plane of "
    "1e-3";

constexpr StabilityCase kGateCases[] = {
    GateCase("slope from width 1 to 1e-6", "1 / (2 T w) at the threshold, within 1e-8", GateSlope),
    GateCase("threshold 0",
             "what is equal or nearer passes, at any width; the least number beyond, infinity and "
             "NaN do not",
             GateAtThresholdZero),
    GateCase("thresholds beyond the range",
             "refused with the parameter's name, and limited by a search", GateBeyondRange),
    GateCase(
        "stiff gate",
        "the calibration's fit stays in its range and descends at any width, where a plain step "
        "leaves a thousand ranges behind",
        StiffGateSteps),
    GateCase(
        "narrowing",
        "from a start twenty times too large within 5e-4 of the least loss, whatever the widths",
        GateNarrowing),
    GateCase("threshold that content does not show",
             "told as not needed, without standard error, left at its start", GateNotIdentified),
    GateCase("threshold without an optimum",
             "as good as the best, at the end of its range, without standard error",
             GateWithoutOptimum),
    GateCase("depth codes and T_D",
             "distances from which one code is more than T_D, within a code of the derived ones",
             DepthCodesAsDerived),
    GateCase("T_D with 16 bits forward", kDepthRequired, DepthGate16Forward,
             "beyond 3 units one code of depth is more than T_D: a surface whose depth changes by "
             "a code loses its history there and is shown from the current frame alone"),
    GateCase("T_D with 16 bits reversed", kDepthRequired, DepthGate16Reversed,
             "as with 16 bits forward, from 3 units on: integers are as coarse either way round"),
    GateCase("T_D with 24 bits forward", kDepthRequired, DepthGate24Forward,
             "beyond 800 units one code of depth is more than T_D, and a surface whose depth "
             "changes by a code loses its history"),
    GateCase("T_D with 24 bits reversed", kDepthRequired, DepthGate24Reversed,
             "as with 24 bits forward, from 800 units on: integers are as coarse either way round"),
    GateCase("T_D with float forward", kDepthRequired, DepthGateFloatForward,
             "beyond 800 units one code of depth is more than T_D: near 1 a float is no finer "
             "than 24 bits"),
    GateCase("T_D with float reversed", kDepthRequired, DepthGateFloatReversed),
    GateCase("T_D with 24 bits from 0.1 to 1000",
             "neighbouring codes pass the default T_D up to the far plane", DepthGate24Moderate),
};

}  // namespace

std::span<const StabilityCase> GateCases() { return kGateCases; }

}  // namespace warplut
