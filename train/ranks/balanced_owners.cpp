#include <algorithm>
#include <numeric>

#include "train/ranks/ranks.h"

namespace warplut {

std::vector<int> BalancedOwners(std::span<const double> work, int ranks) {
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
  std::vector<double> sums(static_cast<std::size_t>(ranks), 0.0);
  std::vector<int> owners(work.size(), 0);
  for (const std::size_t i : order) {
    const auto least = std::min_element(sums.begin(), sums.end());
    *least += work[i];
    owners[i] = static_cast<int>(least - sums.begin());
  }
  return owners;
}

std::vector<int> ContiguousOwners(std::span<const double> work, int ranks) {
  const double total = std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<int> owners;
  double before = 0;
  for (const double piece : work) {
    const double middle = (before + piece / 2) / total;
    owners.push_back(std::min(ranks - 1, static_cast<int>(middle * ranks)));
    before += piece;
  }
  return owners;
}

}  // namespace warplut
