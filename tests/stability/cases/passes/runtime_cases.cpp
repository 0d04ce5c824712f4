#include "tests/stability/cases/passes/runtime_input_cases.h"
#include "tests/stability/cases/passes/runtime_size_cases.h"
#include "tests/stability/cases/passes/runtime_time_cases.h"

namespace warplut {
namespace {

// What Examination checks.
constexpr char kSound[] =
    "finite, in range with the table's overshoot, the same bits on 1, 2 and 5 threads, the plain "
    "version to half a code value";
constexpr char kStill[] =
    "as without history: each frame alone; between frames their mean, to 1e-6";

constexpr StabilityCase Runtime(const char* name, const char* required,
                                StabilityResult (*run)(StabilityEffort),
                                const char* failing = nullptr) {
  return {.group = "runtime", .name = name, .required = required, .run = run, .failing = failing};
}

constexpr StabilityCase kRuntimeCases[] = {
    Runtime("warp with motion NaN and infinite",
            "as with 0 in that component, within the bound of the warp", WarpOddMotion),
    Runtime("warp with motion from 1e6 pixels on", "the texel of the corner, to 1e-6",
            WarpFarMotion),
    Runtime("warp at 1 x 1 to 7680 x 3",
            "within the bound of the plain version, in range with the table's overshoot",
            WarpSizes),
    Runtime("motion NaN and infinite", kStill, MotionNotFinite),
    Runtime(
        "motion of 1e6 pixels",
        "as without history; extrapolation shows the texel of the corner, to 1e-6, a mesh to 0.01",
        MotionOfAMillionPixels),
    Runtime("motion wild in a third of the pixels", kSound, MotionWild),
    Runtime("motion filter with a third of the motion wild",
            "the rest within a quarter of its rounding of exact motion, the plain version to 1e-5",
            MotionFilterWild),
    Runtime("motion filter on upsampled wild motion", "the plain version to 1e-3 pixels",
            MotionFilterUpsampledWild,
            "in about one frame in 15 the fast and the plain motion filter decide differently for "
            "some vectors, by up to 1.2 pixels"),
    Runtime("depth NaN infinite or negative", "the bits of the farthest depth", DepthNotFinite),
    Runtime("depth all equal", "the same bits for 0, 1e-30, 1e-3, 1, 1e5, 1e30 as for 0.5",
            DepthAllEqual),
    Runtime(
        "depth reversed",
        "sound, and the same image 40 pixels away from the object to the rounding of half floats, "
        "as "
        "tiles that it touches are warped by another kernel; in the adaptive form, which judges "
        "regions, to half a code value",
        DepthReversed),
    Runtime("colour NaN infinite or out of range", kSound, ColorNotFinite),
    Runtime("alpha 0 and 1 and outside", "refused with a sentence that names alpha", AlphaOutside),
    Runtime(
        "alpha 1e-6 and 1 - 1e-6",
        "the frame at that end to half a code value; with objects but for 2 percent of the pixels",
        AlphaNearTheEnds),
    Runtime("size 1 x 1 and 3 x 3", kSound, SmallSizes),
    Runtime("odd sizes", kSound, OddSizes),
    Runtime("size 7680 wide", kSound, WideSizes),
    Runtime("scale 1 and 1.01 and 1.3 and 4", kSound, Scales),
    Runtime("constant image at any size", "within half a code value, in any format of history",
            ConstantAtAnySize),
    Runtime("empty history", "the bits of the current frame alone", EmptyHistory),
    Runtime("camera cut in each frame",
            "as without history: each frame alone; between frames the later one, to 1e-6",
            CutInEachFrame),
    Runtime("all disoccluded",
            "as without history: each frame alone; between frames the farther one, to 1e-6",
            AllDisoccluded),
    Runtime("all gates shut",
            "as without history where depth differs by 2 percent and thresholds are least, to 1e-6",
            AllGatesShut),
    Runtime("two objects of equal depth that meet",
            "the first in reading order is shown, by every version, on 1, 2 and 5 threads",
            EqualDepthTies),
    Runtime("two overlapping objects of equal depth", kSound, EqualDepthOverlap),
};

}  // namespace

std::span<const StabilityCase> RuntimeCases() { return kRuntimeCases; }

}  // namespace warplut
