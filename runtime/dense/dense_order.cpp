#include "runtime/dense_order.h"

#include <cmath>

#include "runtime/core/parameter_range.h"

namespace warplut {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Whether x, of any period, lies in (low, high) after its integer part is removed.
bool FractionIsIn(const DenseParameters& parameters, float x) {
  const float fraction = x - std::floor(x);
  return fraction > parameters.order_low && fraction < parameters.order_high;
}

BlockOrder HourglassIf(bool is_hourglass) {
  return is_hourglass ? BlockOrder::kHourglass : BlockOrder::kBowtie;
}

}  // namespace

bool DenseParameters::IsValid(std::string* why) const {
  return AreInRange(*this, kDenseParameters, why);
}

BlockOrder ChooseOrder(OrderRule rule, const DenseParameters& parameters, float x, float y,
                       std::uint32_t random) {
  if (rule == OrderRule::kHourglass) return BlockOrder::kHourglass;
  if (rule == OrderRule::kBowtie) return BlockOrder::kBowtie;
  const float length = std::hypot(x, y);
  const float angle = std::atan2(std::abs(y), std::abs(x));
  const bool mixed = rule == OrderRule::kMixed;
  if (mixed && std::abs(angle - kPi / 4) < parameters.random_angle) {
    return HourglassIf((random & 1) != 0);
  }
  if (rule == OrderRule::kDominant) {
    return HourglassIf(FractionIsIn(parameters, length) == (angle < kPi / 4));
  }
  if (rule == OrderRule::kRising || (mixed && angle < kPi / 4)) {
    return HourglassIf(FractionIsIn(parameters, length - angle / kPi));
  }
  return HourglassIf(!FractionIsIn(parameters, length - (kPi / 2 - angle) / kPi));
}

}  // namespace warplut
