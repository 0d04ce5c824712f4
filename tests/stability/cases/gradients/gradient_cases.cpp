#include "tests/stability/cases/gradients/gradient_objectives.h"
#include "tests/stability/cases/gradients/gradient_parts.h"

namespace warplut {
namespace {

constexpr StabilityCase Gradient(const char* name, const char* required,
                                 StabilityResult (*run)(StabilityEffort),
                                 const char* failing = nullptr) {
  return {.group = "gradients", .name = name, .required = required, .run = run, .failing = failing};
}

constexpr const char* kHeadRequired =
    "complex step of the slow head, within 1e-13 of the gradient's size";
constexpr const char* kRolloutRequired =
    "complex step of rollouts in double, within 1e-4 of the gradient's size";
constexpr const char* kLooseRequired =
    "complex step of rollouts in double, within 1e-3 of the gradient's size";

constexpr StabilityCase kGradientCases[] = {
    Gradient(
        "SSIM",
        "complex step of the direct sums, within 1e-3 of the largest element; exactly 0 for equal "
        "images",
        SsimGradient),
    Gradient("head and MLP", kHeadRequired, HeadGradient),
    Gradient("head and MLP saturated", kHeadRequired, HeadGradientSaturated),
    Gradient("head and MLP near 0", kHeadRequired, HeadGradientTiny),
    Gradient("head at offsets 0, one half and 1 - eps", "complex step, within 1e-14",
             HeadGradientAtExtremeOffsets),
    Gradient("penalty on gain", "fourth-order differences, within 1e-6 of the gradient's size",
             GainPenaltyGradient),
    Gradient("rollouts of 2 to 64 warps", kRolloutRequired, RolloutGradient),
    Gradient("rollouts of extreme content", kRolloutRequired, RolloutGradientOfContent),
    Gradient("rollouts with extreme weights", kRolloutRequired, RolloutGradientOfWeights),
    Gradient("rollouts at offsets 0, one half and 31 of 32", kLooseRequired,
             RolloutGradientAtOffsets),
    Gradient("objective warp", kRolloutRequired, WarpObjectiveGradient),
    Gradient("objective sr", kRolloutRequired, SrObjectiveGradient),
    Gradient("training in the MLP parameters", kRolloutRequired, TrainingGradient),
    Gradient("differences of the calibration",
             "point where fourth-order differences do: cosine at least 0.95",
             CalibrationDifferences),
};

}  // namespace

std::span<const StabilityCase> GradientCases() { return kGradientCases; }

}  // namespace warplut
