#include "runtime/pipeline.h"

namespace warplut {

template <std::uint64_t kDigest>
const char LibraryWithPipeline<kDigest>::kIsLinked = 0;

template struct LibraryWithPipeline<kPipelineDigest>;

}  // namespace warplut
