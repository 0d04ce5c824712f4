#include "tests/stability/cases/gates/gate_depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "datasets/encoding.h"
#include "runtime/gates.h"
#include "runtime/parameters.h"

namespace warplut {
namespace {

struct DepthFormat {
  int bits = 0;  // of an integer code; 0: float
  DepthKind kind = DepthKind::kForward;
  double near = 1e-3, far = 1e5;

  DepthStream Stream() const {
    DepthStream stream;
    stream.kind = kind;
    stream.near = near;
    stream.far = far;
    return stream;
  }
  std::string Name() const {
    return fmt::format("{} {}", bits > 0 ? fmt::format("{} bits", bits) : "float",
                       kind == DepthKind::kForward ? "forward" : "reversed");
  }
};

// The depth of two neighbouring codes of the format, the ones around view depth `distance`, as the
// product decodes them; the nearer first.
std::array<float, 2> NeighbourDepths(const DepthFormat& format, double distance) {
  const DepthStream stream = format.Stream();
  Image depth(1, 1, 1);
  depth.data[0] = static_cast<float>(distance / format.far);
  const float z = EncodeDepth(depth, stream, "").data[0];
  Image codes(2, 1, 1);
  if (format.bits > 0) {
    const double last = std::ldexp(1.0, format.bits) - 1;
    const double code = std::min(std::floor(z * last), last - 1);
    codes.data = {static_cast<float>(code / last), static_cast<float>((code + 1) / last)};
  } else {
    const float below = std::min(z, std::nextafter(1.0f, 0.0f));
    codes.data = {below, std::nextafter(below, 2.0f)};
  }
  const Image decoded = DecodeDepth(codes, stream, "");
  const auto [nearer, farther] = std::minmax(decoded.data[0], decoded.data[1]);
  return {nearer, farther};
}

// What the depth gate sees between the codes.
double Difference(const DepthFormat& format, double distance) {
  const auto [nearer, farther] = NeighbourDepths(format, distance);
  return DepthDifference(DepthMeasure::kRelative, double{farther}, double{nearer});
}

// The view depth from which on neighbouring codes differ by more than the threshold; far where they
// never do.
double RejectedFrom(const DepthFormat& format, double threshold) {
  double low = std::log(2 * format.near), high = std::log(format.far);
  const auto rejects = [&](double logarithm) {
    const double difference = Difference(format, std::exp(logarithm));
    return Gate(difference, threshold, 0.0) == 0;
  };
  if (!rejects(std::log(format.far * (1 - 1e-6)))) return format.far;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (rejects(middle) ? high : low) = middle;
  }
  return std::exp(high);
}

// 1 / D is linear in z: neighbouring codes, dz apart, have 1 / D1 - 1 / D2 = k = dz
// (f - n) / (n f), hence D2 / D1 - 1 = k D2. The gate rejects from D1 = T / (k (1 + T)) on. Forward
// floats below 1 are 2^-24 apart; reversed ones are apart by a part of their size, so that
// D2 / D1 - 1 is at most 2^-23 at any distance.
double DerivedRejection(const DepthFormat& format, double threshold) {
  if (format.bits == 0 && format.kind == DepthKind::kReversed) return format.far;
  const double dz = format.bits > 0 ? 1 / (std::ldexp(1.0, format.bits) - 1) : std::ldexp(1.0, -24);
  const double k = dz * (format.far - format.near) / (format.near * format.far);
  return std::min(threshold / (k * (1 + threshold)), format.far);
}

const double kThreshold = Parameters().sr_depth_threshold;

StabilityResult SameSurfacePasses(const DepthFormat& format) {
  const double from = RejectedFrom(format, kThreshold);
  const double at_far = Difference(format, format.far * (1 - 1e-6));
  return {from >= format.far,
          fmt::format(
              "passes up to {:.4g} of {:g}; neighbouring codes at the far plane differ by {:.2g}",
              from, format.far, at_far)};
}

constexpr DepthFormat kFormats[] = {
    {16, DepthKind::kForward},  {16, DepthKind::kReversed}, {24, DepthKind::kForward},
    {24, DepthKind::kReversed}, {0, DepthKind::kForward},   {0, DepthKind::kReversed},
};

}  // namespace

StabilityResult DepthCodesAsDerived(StabilityEffort) {
  double worst = 0;
  std::string observed;
  for (const DepthFormat& format : kFormats) {
    for (const double threshold : {kThreshold, 1e-2, 1e-3}) {
      const double measured = RejectedFrom(format, threshold);
      const double derived = DerivedRejection(format, threshold);
      // The distance at which the code changes is known to one code, a share T of it.
      worst = std::max(worst, std::abs(measured / derived - 1) / threshold);
      if (threshold == kThreshold) {
        observed += fmt::format("{}: {:.4g}; ", format.Name(), measured);
      }
    }
  }
  return {worst <= 1.1, fmt::format("{}off by at most {:.2f} codes", observed, worst)};
}

StabilityResult DepthGate16Forward(StabilityEffort) { return SameSurfacePasses(kFormats[0]); }
StabilityResult DepthGate16Reversed(StabilityEffort) { return SameSurfacePasses(kFormats[1]); }
StabilityResult DepthGate24Forward(StabilityEffort) { return SameSurfacePasses(kFormats[2]); }
StabilityResult DepthGate24Reversed(StabilityEffort) { return SameSurfacePasses(kFormats[3]); }
StabilityResult DepthGateFloatForward(StabilityEffort) { return SameSurfacePasses(kFormats[4]); }
StabilityResult DepthGateFloatReversed(StabilityEffort) { return SameSurfacePasses(kFormats[5]); }

StabilityResult DepthGate24Moderate(StabilityEffort) {
  return SameSurfacePasses({24, DepthKind::kForward, 0.1, 1000});
}

}  // namespace warplut
