// Temporal upsampling (docs/METHODS.md): formulas that its plain and its fast version share.
//
//   s = sum of g(d) s_i / sum of g(d)   over 3 x 3 samples, d the distance in output pixels,
//                                       g(d) = exp(-kSampleFalloff d^2)
//   h = the history, limited to mean - gamma sigma and mean + gamma sigma of the 3 x 3 samples
//   q = h + alpha g(d of the nearest sample) (s - h)
#pragma once

namespace warplut::peers {

// Gives the sample kernel a standard deviation of 0.47 output pixels: the Gaussian that renderers
// take for a Blackman-Harris window of 3.3 pixels.
inline constexpr float kSampleFalloff = 2.29f;

}  // namespace warplut::peers
