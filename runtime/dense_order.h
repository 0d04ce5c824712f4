// The order in which the pixels of a 2 x 2 block are sampled, and the rule that chooses it by the
// block's motion (runtime/dense_rendering.h).
//
// The pixels of a block are 0 upper left, 1 upper right, 2 lower left, 3 lower right. Hourglass
// takes 0 1 2 3: the two of a row follow each other. Bowtie takes 0 2 1 3: the two of a column do.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <string>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

enum class BlockOrder : std::uint8_t { kHourglass, kBowtie };

// The place of pixel i of a block in the order, 0 to 3; also the pixel at that place, as each order
// is its own inverse.
constexpr int PlaceInOrder(BlockOrder order, int i) {
  return order == BlockOrder::kBowtie && (i == 1 || i == 2) ? 3 - i : i;
}

// l is the fraction of the motion's length in pixels per subframe, a its angle from the x axis,
// folded to [0, pi / 2]. With low and high of the parameters:
//   kDominant  a < pi / 4: hourglass if l is in (low, high); else bowtie if it is
//   kRising    hourglass if frac(l - a / pi) is in (low, high)
//   kFalling   bowtie if frac(l - (pi / 2 - a) / pi) is in (low, high)
//   kMixed     kRising up to pi / 4 - random_angle, kFalling from pi / 4 + random_angle, between
//              them either, at random
// All but the first two take equation 4 of the paper at a = 0 and equation 5 at a = pi / 2. The
// paper shows the transitions as pictures alone; these are the two that move its intervals by half
// a period, and each is the other with x and y exchanged.
enum class OrderRule : std::uint8_t { kHourglass, kBowtie, kDominant, kRising, kFalling, kMixed };

inline constexpr OrderRule kOrderRules[] = {OrderRule::kHourglass, OrderRule::kBowtie,
                                            OrderRule::kDominant,  OrderRule::kRising,
                                            OrderRule::kFalling,   OrderRule::kMixed};

constexpr const char* Name(OrderRule rule) {
  switch (rule) {
    case OrderRule::kHourglass:
      return "hourglass";
    case OrderRule::kBowtie:
      return "bowtie";
    case OrderRule::kDominant:
      return "dominant";
    case OrderRule::kRising:
      return "rising";
    case OrderRule::kFalling:
      return "falling";
    case OrderRule::kMixed:
      return "mixed";
  }
  return "";
}

// The numbers of temporally dense rendering, as published. The paper does not tell gamma; 1 is that
// of Salvi (GDC 2016), its source.
struct DenseParameters {
  float gamma = 1.0f;
  float static_motion = 0.0f;
  float order_low = 0.25f;
  float order_high = 0.75f;
  float random_angle = std::numbers::pi_v<float> / 40;

  bool operator==(const DenseParameters&) const = default;

  // Whether every value lies in its range; otherwise *why (if not null) names the first one
  // outside, with its range.
  bool IsValid(std::string* why = nullptr) const;
};

struct DenseParameterInfo {
  const char* name;  // as on the command line
  float DenseParameters::*member;
  float min, max;
  const char* meaning;
};

inline constexpr std::array<DenseParameterInfo, 5> kDenseParameters = {{
    {"gamma", &DenseParameters::gamma, 0.0f, 16.0f,
     "half width of the variance box in standard deviations"},
    {"static_motion", &DenseParameters::static_motion, 0.0f, 1.0f,
     "longest motion of a static pixel, pixels per subframe"},
    {"order_low", &DenseParameters::order_low, 0.0f, 0.5f,
     "fraction of the motion's length from which a horizontal one takes the hourglass"},
    {"order_high", &DenseParameters::order_high, 0.5f, 1.0f,
     "fraction of the motion's length up to which a horizontal one takes the hourglass"},
    {"random_angle", &DenseParameters::random_angle, 0.0f, 0.7853981f,
     "angle around the diagonal within which the order is random, radians"},
}};

// The order by the rule for motion (x, y), finite, in pixels per subframe. `random` decides by its
// lowest bit where the rule does not.
BlockOrder ChooseOrder(OrderRule rule, const DenseParameters& parameters, float x, float y,
                       std::uint32_t random);

}  // namespace warplut
