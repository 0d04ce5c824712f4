// Stateless random numbers: a value depends on its indices only, never on the order of evaluation.
#pragma once

#include <cstdint>

namespace warplut::scenes {

// A bijective 32-bit mix (the "lowbias32" constants of C. Wellons' hash prospector).
inline std::uint32_t Hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}

inline std::uint32_t Hash(std::uint32_t a, std::uint32_t b) {
  return Hash(a ^ Hash(b + 0x9e3779b9U));
}

inline std::uint32_t Hash(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return Hash(a ^ Hash(b ^ Hash(c + 0x9e3779b9U)));
}

// [0, 1)
inline float Unit(std::uint32_t h) { return static_cast<float>(h >> 8) * 0x1p-24f; }

// A counter-based stream, for the placement of things when a scene is built.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint32_t stream = 0)
      : key_(Hash(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                  stream)) {}

  std::uint32_t Bits() { return Hash(key_, counter_++); }
  // Uniform in [low, high).
  double operator()(double low, double high) { return low + (high - low) * Unit(Bits()); }
  // Uniform in 0..count-1.
  int Below(int count) { return static_cast<int>(Bits() % static_cast<std::uint32_t>(count)); }

 private:
  std::uint32_t key_;
  std::uint32_t counter_ = 0;
};

}  // namespace warplut::scenes
