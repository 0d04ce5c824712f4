// Differences of images as colours.
#pragma once

#include <string>

#include "datasets/image.h"

namespace warplut {

// For each pixel the largest |difference| over R, G, B, `amplify` times, from black (0) over violet
// and orange to pale yellow (1 and more). Images of one size with 3 channels; amplify > 0.
Image ErrorMap(const Image& image, const Image& truth, double amplify);

// "x 4"
std::string ErrorFactor(double amplify);

// "x 4: black is 0, pale yellow is 0.25 or more"
std::string ErrorLegend(double amplify);

}  // namespace warplut
