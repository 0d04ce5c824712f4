// A small generator whose numbers are the same on every machine and with every standard library
// (the library's distributions are not). SplitMix64; source: Steele, Lea, Flood 2014.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace warplut {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  // Uniform in [0, 1), 53 bits.
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1p-53; }

  // Uniform in 0 .. n - 1, n >= 1.
  int Below(int n) { return static_cast<int>(Uniform() * n); }

  // Standard normal (Box and Muller).
  double Normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * Uniform());
  }

 private:
  std::uint64_t state_;
};

// A seed for part `index` of something seeded with `seed`.
inline std::uint64_t DeriveSeed(std::uint64_t seed, std::uint64_t index) {
  return Random(seed ^ (index * 0xd1342543de82ef95u)).Next();
}

}  // namespace warplut
