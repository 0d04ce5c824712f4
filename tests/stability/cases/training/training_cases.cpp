#include "tests/stability/cases/training/training_content.h"
#include "tests/stability/cases/training/training_data.h"
#include "tests/stability/cases/training/training_starts.h"
#include "tests/stability/cases/training/training_weights.h"

namespace warplut {
namespace {

constexpr StabilityCase Training(const char* name, const char* required,
                                 StabilityResult (*run)(StabilityEffort),
                                 const char* failing = nullptr) {
  return {.group = "training", .name = name, .required = required, .run = run, .failing = failing};
}

constexpr const char* kFlatRequired =
    "loss at most 4e-5, what rounding alone may cost; gradient at most 1e-9; the trainer refuses "
    "such data alone";
constexpr const char* kContentRequired =
    "finite, not above the start; the certificate allows the 6 warps of the longest horizon; sums "
    "within 1e-12, offset 0 exact";

constexpr StabilityCase kTrainingCases[] = {
    Training("constant image", kFlatRequired, TrainOnConstant),
    Training("black image", kFlatRequired, TrainOnBlack),
    Training("white image", kFlatRequired, TrainOnWhite),
    Training("impulse of one pixel", kContentRequired, TrainOnImpulse),
    Training("Nyquist checkerboard",
             "as other content, and the half-pixel loss is 1 - C2 / (1/4 + C2) within 1e-5",
             TrainOnCheckerboard),
    Training("white noise", kContentRequired, TrainOnWhiteNoise),
    Training("HDR of 1e-4 to 1e4 after tone mapping", kContentRequired, TrainOnToneMappedHdr),
    Training("constant image beside noise", kContentRequired, TrainOnFlatAndNoise),
    Training(
        "what cannot be trained",
        "no image, a small one, NaN, infinite, negative or HDR values, bad horizons, bounds and "
        "scales: refused, each with a sentence",
        RefuseWhatCannotBeTrained),
    Training(
        "parameters times 1e3",
        "saturated tanh: finite, not above the start; the certificate allows 6 warps; sums within "
        "1e-12, offset 0 exact",
        TrainFromSaturated),
    Training("parameters times 1e-6",
             "finite, at most 0.9 of the start; the certificate allows 6 warps; sums within 1e-12, "
             "offset 0 exact",
             TrainFromTiny),
    Training(
        "optimum from parameters times 1e3",
        "within 5 % of the end from the parameters as they are", OptimumFromSaturated,
        "the hidden layers have no gradient, and the bound on gain leaves all but nothing of the "
        "residual: Catmull-Rom weights; no training starts there"),
    Training(
        "optimum from parameters times 1e-6",
        "within 5 % of the end from the parameters as they are", OptimumFromTiny,
        "the last biases alone have a gradient: it ends at the best raw values that do not depend "
        "on the offset; no training starts there"),
    Training("offsets 0, one half and 1 - eps",
             "identity at 0 and at 1 - eps, 8 symmetries at 1/2, each within 32 eps (1 + size of "
             "F), up to saturation",
             HeadAtExtremeOffsets),
    Training("head whose sum vanishes",
             "sums within 1e-15, weights change by at most 9/4 of the raw values' change",
             HeadOfVanishingSum),
    Training("duplicate images", "the same bits as with one of them", TrainOnDuplicates),
    Training("one image of the least size",
             "a valid fit, validation not above that of the first stage", TrainOnOneImage),
    Training("one and two threads", "the same bits", TrainOnThreads),
    Training("horizons 2 to 64",
             "finite, not above the start, the certificate allows the horizon's warps",
             TrainOverHorizons),
    Training("random starts",
             "every end keeps the contract, allows its warps and is at most 1.2 times the best",
             TrainFromManyStarts),
    Training("Gauss-Newton matrix at the end",
             "finite, and a damping of at most 1000 times its largest eigenvalue makes a step that "
             "descends",
             GaussNewtonAtTheEnd),
};

}  // namespace

std::span<const StabilityCase> TrainingCases() { return kTrainingCases; }

}  // namespace warplut
