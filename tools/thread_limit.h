// The threads that TBB may use while this object lives.
#pragma once

#include <tbb/global_control.h>

#include <cstddef>
#include <optional>

namespace warplut {

class ThreadLimit {
 public:
  // 0: as many as the processor runs at once.
  explicit ThreadLimit(int threads) {
    if (threads > 0) {
      limit_.emplace(tbb::global_control::max_allowed_parallelism,
                     static_cast<std::size_t>(threads));
    }
  }

 private:
  std::optional<tbb::global_control> limit_;
};

}  // namespace warplut
