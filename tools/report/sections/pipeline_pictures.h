// Pictures of what pipelines make: where they err most, and what was just revealed.
#pragma once

#include <vector>

#include "tools/report/report_inputs.h"
#include "tools/report/report_section.h"

namespace warplut {

// Of the clip: super resolution beside bilinear upscaling and beside the reference, and
// interpolation beside the reference, at their worst window and at that where most was revealed.
std::vector<ReportPicture> PipelinePictures(const ReportInputs& inputs, const ReportClip& clip,
                                            Executor& executor);

}  // namespace warplut
