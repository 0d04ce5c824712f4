#include "train/fit/resampler_model.h"

namespace warplut {

const Resampler& ResamplerModel::Evaluate(const double* parameters,
                                          const RealPrefilter& prefilter) {
  if (HasPrefilter(prefilter)) head_.SetSide(prefilter.side);
  resampler_ = {head_.Forward(parameters), prefilter, footprint()};
  return resampler_;
}

const Resampler& ResamplerModel::Forward(const double* parameters) {
  return Evaluate(parameters, map_.At(parameters + mlp_size()));
}

const Resampler& ResamplerModel::ForwardStored(const double* parameters) {
  return Evaluate(parameters, ToReal(Rounded(map_.At(parameters + mlp_size()))));
}

void ResamplerModel::Backward(const double* parameters, const Resampler& gradient,
                              double* parameter_gradient) {
  head_.Backward(parameters, gradient.weights, parameter_gradient);
  if (map_.size() == 0) return;
  RealPrefilter of_prefilter = gradient.prefilter;
  of_prefilter.side += head_.SideGradient(gradient.weights);
  map_.Backward(parameters + mlp_size(), of_prefilter, parameter_gradient + mlp_size());
}

}  // namespace warplut
