// Not the configuration of the installed library, whatever that is: no build contains this
// combination alone.
#include "runtime/pipeline_configuration.h"

namespace warplut {

inline constexpr PipelineConfiguration kPipeline = {
    .extrapolation = false,
    .filter = Filter::kKeys,
    .sr = {.form = HistoryForm::kSample, .current = CurrentFrame::kBicubic},
};

}  // namespace warplut
