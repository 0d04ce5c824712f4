// Parameters -> resampler, with the gradient: MLP, head and prefilter.
//
// Parameters are those of the MLP (MlpParameters of the footprint), then the numbers of the
// prefilter (train/fit/objective/prefilter_map.h). The head's weights depend on the prefilter
// through its side.
#pragma once

#include <vector>

#include "train/fit/objective/head_batch.h"
#include "train/fit/objective/prefilter_map.h"
#include "train/fit/resampler.h"

namespace warplut {

// One object serves one thread.
class ResamplerModel {
 public:
  // Of 16 taps, with a prefilter or none.
  explicit ResamplerModel(const PrefilterMap& prefilter = {}) : map_(prefilter) {}
  // Of 24 or 36 taps, with the wide kernel of parameter b.
  ResamplerModel(Footprint footprint, double kaiser_b)
      : kaiser_b_(kaiser_b), head_(footprint, kaiser_b) {}

  Footprint footprint() const { return head_.footprint(); }
  double kaiser_b() const { return kaiser_b_; }
  int mlp_size() const { return MlpParameters(footprint()); }
  int size() const { return mlp_size() + map_.size(); }
  const PrefilterMap& map() const { return map_; }

  // The resampler of size() parameters; valid until the next call.
  const Resampler& Forward(const double* parameters);

  // The same as a fit stores it: the prefilter rounded to float, the weights of its rounded side.
  const Resampler& ForwardStored(const double* parameters);

  // After Forward with the same parameters: writes d(loss)/d(parameters), given
  // d(loss)/d(resampler).
  void Backward(const double* parameters, const Resampler& gradient, double* parameter_gradient);

 private:
  const Resampler& Evaluate(const double* parameters, const RealPrefilter& prefilter);

  PrefilterMap map_;
  double kaiser_b_ = 0;
  HeadBatch head_;
  Resampler resampler_;
};

}  // namespace warplut
