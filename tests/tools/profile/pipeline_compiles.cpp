// The header that a profile writes is what the runtime's headers take; never linked, as the other
// tests have a runtime of their own.
#define WARPLUT_PIPELINE_HEADER "tests/tools/profile/pipeline.h"
#include "runtime/frame_generation.h"
#include "runtime/super_resolution.h"

namespace warplut {

static_assert(kPipeline.super_resolution && kPipeline.interpolation);
static_assert(!kPipeline.extrapolation && !kPipeline.reference);
static_assert(kPipeline.filter == Filter::kCatmullRom);
static_assert(kPipeline.sr.motion == MotionUpsampling::kEdgeAware);
static_assert(kPipeline.sr.history_format == PixelFormat::kRgba16F);
static_assert(kPipeline.generation.depth == DepthMeasure::kNone);
static_assert(SuperResolutionOptions().form == HistoryForm::kSample);
static_assert(!FrameGenerationOptions().refine);

}  // namespace warplut
