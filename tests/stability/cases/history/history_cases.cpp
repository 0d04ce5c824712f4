#include "tests/stability/cases/history/history_sr_cases.h"
#include "tests/stability/cases/history/history_warp_cases.h"

namespace warplut {
namespace {

constexpr StabilityCase History(const char* name, const char* required,
                                StabilityResult (*run)(StabilityEffort),
                                const char* failing = nullptr) {
  return {.group = "history", .name = name, .required = required, .run = run, .failing = failing};
}

constexpr StabilityCase kHistoryCases[] = {
    History("warps of a static image", "not one bit changes, in any format", WarpOfStaticImage),
    History("warps of a constant image", "within half a code value, in any format",
            WarpOfConstantImage),
    History("warps of the worst wave",
            "grows as predicted, to 0.1 percent, and at most twofold within the safe warps",
            WarpOfWorstWave),
    History("warps of a pan", "contrast within the prediction of the gain, in any format", WarpPan),
    History("blend of the worst wave in phase",
            "as large as predicted, to 1 percent, and within the bound in any format",
            LoopOfWorstWave),
    History("blend of a pan",
            "contrast within the closed-loop prediction, mean within half a code value", LoopPan),
    History("blend of a flicker", "contrast within the closed-loop prediction", LoopFlicker),
    History("blend of a constant image", "within half a code value, in any format", LoopConstant),
    History("super resolution of a static image", "settles to the same bits, RGBA8 and RGBA16F",
            SrStaticImage),
    History("super resolution of a static image in float", "settles to the same bits, RGBA32F",
            SrStaticImageInFloat,
            "the histories of sr and sr-residual still move after 100,000 frames, "
            "by less than 1e-6 of white; sr-sample and sr-paper settle to the same bits"),
    History("super resolution under a jitter cycle",
            "the same image after each cycle, within half a code value", SrJitterCycle),
    History("super resolution of a constant image",
            "within half a code value, in any format, with pan and jitter", SrConstantImage),
    History(
        "super resolution of a pan",
        "error at most 1.05 of that of frames 100 to 199, contrast at most 1.05 of the content's",
        SrPan),
    History(
        "super resolution of a flicker",
        "settles to two images within half a code value, RGBA8 within one; the swing does not grow",
        SrFlicker),
    History(
        "super resolution of a flicker in the residual form",
        "settles to two images within half a code value, RGBA8 within one; the swing does not grow",
        SrFlickerOfResidualForm,
        "the swing of the method sr-residual settles slowly, 2.3 percent above that of pair 10; "
        "after some hundred pairs it grows no more"),
};

}  // namespace

std::span<const StabilityCase> HistoryCases() { return kHistoryCases; }

}  // namespace warplut
