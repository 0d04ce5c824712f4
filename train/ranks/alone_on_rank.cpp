#include <utility>

#include "train/ranks/ranks.h"

namespace warplut {

AloneOnRank::AloneOnRank()
    : rank_(std::exchange(Ranks::World().rank_, 0)),
      count_(std::exchange(Ranks::World().count_, 1)) {}

AloneOnRank::~AloneOnRank() {
  Ranks::World().rank_ = rank_;
  Ranks::World().count_ = count_;
}

}  // namespace warplut
