#include "datasets/luma.h"
#include "runtime/generation/blend.h"

namespace warplut::generation {
namespace {

// The runtime links no datasets, so that the weights are written down in both: they are held together here.
static_assert(kBrightnessWeights[0] == static_cast<float>(kLumaWeights[0]));
static_assert(kBrightnessWeights[1] == static_cast<float>(kLumaWeights[1]));
static_assert(kBrightnessWeights[2] == static_cast<float>(kLumaWeights[2]));

}  // namespace
}  // namespace warplut::generation
