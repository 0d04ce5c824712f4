// The subject of a training and an objective: the weights of the canonical nodes, and the prefilter
// that they read through.
#pragma once

#include <iterator>
#include <span>
#include <vector>

#include "luts/prefilter.h"
#include "train/fit/objective/canonical_nodes.h"

namespace warplut {

// As a gradient it holds the derivatives with respect to the same numbers: side and taps, each
// taken to be independent of the others and of the weights; its footprint says nothing.
struct Resampler {
  Resampler() = default;
  // Without prefilter where none is given.
  Resampler(const CanonicalWeights<double>& node_weights, const RealPrefilter& before = {},
            Footprint taps = Footprint::k16)
      : weights(node_weights), prefilter(before), footprint(taps) {}

  // Adds factor times the numbers of another.
  void Add(double factor, const Resampler& other) {
    for (int c = 0; c < kCanonicalNodes; ++c) {
      for (int k = 0; k < kWeights; ++k) weights[c][k] += factor * other.weights[c][k];
    }
    prefilter.side += factor * other.prefilter.side;
    for (int j = 0; j <= kLargestFirReach; ++j) {
      prefilter.taps[j] += factor * other.prefilter.taps[j];
    }
  }

  // The numbers that Add adds, one after another.
  std::vector<double> Numbers() const {
    std::vector<double> numbers;
    for (const auto& node : weights) numbers.insert(numbers.end(), node.begin(), node.end());
    numbers.push_back(prefilter.side);
    numbers.insert(numbers.end(), std::begin(prefilter.taps), std::end(prefilter.taps));
    return numbers;
  }

  // Sets them; `numbers` has as many as Numbers() gives.
  void SetNumbers(std::span<const double> numbers) {
    const double* next = numbers.data();
    for (auto& node : weights) {
      for (double& weight : node) weight = *next++;
    }
    prefilter.side = *next++;
    for (double& tap : prefilter.taps) tap = *next++;
  }

  CanonicalWeights<double> weights{};
  RealPrefilter prefilter = {};
  Footprint footprint = Footprint::k16;
};

}  // namespace warplut
