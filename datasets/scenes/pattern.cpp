#include "datasets/scenes/pattern.h"

#include "datasets/scenes/hash.h"

namespace warplut::scenes {

Height Noise(Vec2f p, std::uint32_t seed) {
  const std::int32_t cell_x = Floor(p.x()), cell_y = Floor(p.y());
  const auto ix = static_cast<std::uint32_t>(cell_x), iy = static_cast<std::uint32_t>(cell_y);
  const float x = p.x() - static_cast<float>(cell_x), y = p.y() - static_cast<float>(cell_y);
  const std::uint32_t row0 = Hash(iy + seed), row1 = Hash(iy + 1 + seed);
  const auto gradient = [](std::uint32_t h, float& gx, float& gy) {
    gx = static_cast<float>(h & 0xffffU) * (1 / 32768.f) - 1;
    gy = static_cast<float>(h >> 16) * (1 / 32768.f) - 1;
  };
  float ax, ay, bx, by, cx, cy, dx, dy;
  gradient(Hash(row0 ^ ix), ax, ay);
  gradient(Hash(row0 ^ (ix + 1)), bx, by);
  gradient(Hash(row1 ^ ix), cx, cy);
  gradient(Hash(row1 ^ (ix + 1)), dx, dy);
  const float a = ax * x + ay * y, b = bx * (x - 1) + by * y;
  const float c = cx * x + cy * (y - 1), d = dx * (x - 1) + dy * (y - 1);
  const float u = x * x * x * (x * (x * 6 - 15) + 10), v = y * y * y * (y * (y * 6 - 15) + 10);
  const float du = 30 * x * x * (x * (x - 2) + 1), dv = 30 * y * y * (y * (y - 2) + 1);
  const float k = a - b - c + d;
  return {
      .value = a + u * (b - a) + v * (c - a) + u * v * k,
      .dx = ax + u * (bx - ax) + v * (cx - ax) + u * v * (ax - bx - cx + dx) + du * (b - a + v * k),
      .dy =
          ay + u * (by - ay) + v * (cy - ay) + u * v * (ay - by - cy + dy) + dv * (c - a + u * k)};
}

Height Fbm(Vec2f p, float footprint, int octaves, float gain, std::uint32_t seed) {
  Height sum;
  float frequency = 1, amplitude = 1;
  for (int k = 0; k < octaves; ++k) {
    const float visible = 1 - SmoothStep(0.35f, 0.7f, frequency * footprint);
    if (visible <= 0) break;
    const Height n = Noise(p * frequency, seed + 0x632be5abU * static_cast<std::uint32_t>(k));
    const float weight = amplitude * visible;
    sum.value += weight * n.value;
    sum.dx += weight * frequency * n.dx;
    sum.dy += weight * frequency * n.dy;
    frequency *= 2;
    amplitude *= gain;
  }
  return sum;
}

float Pulse(float x, float duty, float footprint) {
  const float w = std::max(footprint, 1e-5f);
  const auto integral = [duty](float t) {
    const auto whole = static_cast<float>(Floor(t));
    return whole * duty + std::min(t - whole, duty);
  };
  return Saturate((integral(x + 0.5f * w) - integral(x - 0.5f * w)) / w);
}

float Checker(Vec2f p, float footprint) {
  const float x = 2 * Pulse(0.5f * p.x(), 0.5f, 0.5f * footprint) - 1;
  const float y = 2 * Pulse(0.5f * p.y(), 0.5f, 0.5f * footprint) - 1;
  return 0.5f + 0.5f * x * y;
}

}  // namespace warplut::scenes
