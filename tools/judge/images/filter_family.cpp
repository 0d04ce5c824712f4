#include "tools/judge/images/filter_family.h"

#include "tools/judge/images/protocol_filter.h"

namespace warplut {
namespace {

ProtocolFilter KeysFilter(double a) {
  return RuntimeFilter(KeysName(a), {.filter = Filter::kKeys, .keys_a = static_cast<float>(a)});
}

ProtocolFilter SplineFilter(double k) {
  return RuntimeFilter(SplineName(k),
                       {.filter = Filter::kSpline, .spline_k = static_cast<float>(k)});
}

constexpr FilterFamily kFamilies[] = {
    {.name = kBestKeys,
     .parameter = "keys_a",
     .symbol = "a",
     .low = -1.0,
     .high = -0.3,
     .width = 0.01,
     .digits = 2,
     .make = KeysFilter},
    {.name = kBestSpline,
     .parameter = "spline_k",
     .symbol = "k",
     .low = 0.0,
     .high = static_cast<double>(kLargestSplineK),
     .width = 0.0005,
     .digits = 4,
     .make = SplineFilter},
};

}  // namespace

Maximum FilterFamily::Best(const std::function<double(double parameter)>& score) const {
  return GoldenSection(score, low, high, width);
}

int FilterFamily::Evaluations() const { return GoldenSectionEvaluations(low, high, width); }

const FilterFamily* FindFamily(std::string_view name) {
  for (const FilterFamily& family : kFamilies) {
    if (name == family.name) return &family;
  }
  return nullptr;
}

}  // namespace warplut
