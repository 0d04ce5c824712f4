#include "train/calibration/profile.h"

#include <algorithm>
#include <cmath>

namespace warplut {

double Profile::Spread() const {
  if (points.empty()) return 0;
  const auto less = [](const ProfilePoint& a, const ProfilePoint& b) { return a.loss < b.loss; };
  const auto [least, largest] = std::minmax_element(points.begin(), points.end(), less);
  return largest->loss - least->loss;
}

Profile ProfileOf(RunLog& log, const SearchSpace& space, int i, const Candidate& centre,
                  Candidate* better) {
  const ParameterInfo& info = space.info(i);
  const float value = centre.parameters.*info.member;
  std::vector<float> values;
  for (int k = 0; k <= kProfileSteps; ++k) {
    values.push_back(static_cast<float>(space.Value(i, static_cast<double>(k) / kProfileSteps)));
  }
  for (const double factor : kProfileFactors) {
    values.push_back(static_cast<float>(value * factor));
  }
  for (float& v : values) v = std::clamp(v, info.min, info.max);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());

  Profile profile;
  for (const float v : values) {
    Parameters parameters = centre.parameters;
    parameters.*info.member = v;
    const std::optional<double> loss = log.Loss(parameters);
    if (!loss) break;
    profile.points.push_back({v, *loss});
    if (better != nullptr && *loss < better->loss) *better = {parameters, *loss};
  }
  return profile;
}

}  // namespace warplut
