#include "runtime/dense/dense_job.h"

namespace warplut::dense {

void ComposeRowsReference(const DenseJob& job, int begin, int end) {
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < job.options.width; ++x) {
      const Motion m = LongestMotion(job, x, y, x, y, job.options.motion_radius);
      ComposePixel(job, x, y, m, [&](BoxSums& sums) {
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, job.options.height - 1); ++v) {
          for (int u = std::max(x - 1, 0); u <= std::min(x + 1, job.options.width - 1); ++u) {
            if (job.PlaceOf(u, v) == job.place) sums.Add(job.NewSample(u, v));
          }
        }
      });
    }
  }
}

}  // namespace warplut::dense
