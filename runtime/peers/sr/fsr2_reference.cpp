#include "runtime/peers/sr/fsr2.h"

namespace warplut::peers {

bool IsThinFeature(const SrJob& job, int i, int j, float ratio) {
  const auto luma = [&](int di, int dj) {
    const auto channel = [&](int c) { return job.planes.color[c].Row(j + dj)[i + di]; };
    return LumaOf(channel(0), channel(1), channel(2));
  };
  const float center = luma(0, 0);
  float least = 2, greatest = -1;  // of those that are not alike
  bool alike[3][3];
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const float other = luma(di, dj);
      const bool is_alike = std::max(other, center) < ratio * std::min(other, center);
      alike[dj + 1][di + 1] = is_alike || (di == 0 && dj == 0);
      if (alike[dj + 1][di + 1]) continue;
      least = std::min(least, other);
      greatest = std::max(greatest, other);
    }
  }
  if (!(center > greatest || center < least)) return false;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      if (alike[y][x] && alike[y][x + 1] && alike[y + 1][x] && alike[y + 1][x + 1]) return false;
    }
  }
  return true;
}

void FillShadingRow(const SrJob& job, int j, float* sums, float* shading) {
  const int width = job.x.render();
  const int top = j / kShadingTile * kShadingTile;
  const int bottom = std::min(top + kShadingTile, job.y.render());
  std::fill_n(sums, width, 0.0f);
  for (int y = top; y < bottom; ++y) {
    const float* r = job.planes.color[0].Row(y);
    const float* g = job.planes.color[1].Row(y);
    const float* b = job.planes.color[2].Row(y);
    for (int i = 0; i < width; ++i) sums[i] += LumaOf(r[i], g[i], b[i]);
  }
  for (int left = 0; left < width; left += kShadingTile) {
    const int right = std::min(left + kShadingTile, width);
    float sum = 0;
    for (int i = left; i < right; ++i) sum += sums[i];
    const float mean = sum / static_cast<float>((right - left) * (bottom - top));
    std::fill(shading + left, shading + right, mean);
  }
}

void LimitToTexels(const SrJob& job, const MotionView& motion, int x, int y) {
  const float* m = motion.Row(y) + 2 * x;
  const auto cell = [](float u, int size) {
    return static_cast<int>(std::floor(std::clamp(u, -1.0f, static_cast<float>(size))));
  };
  const int left = cell(static_cast<float>(x) - m[0], job.history.width);
  const int top = cell(static_cast<float>(y) - m[1], job.history.height);
  for (int c = 0; c < 3; ++c) {
    float low = 0, high = 0;
    for (int k = 0; k < 4; ++k) {
      const int tx = std::clamp(left + k % 2, 0, job.history.width - 1);
      const int ty = std::clamp(top + k / 2, 0, job.history.height - 1);
      const float texel = LoadChannel(job.history.format, job.history.At(tx, ty), c);
      low = k == 0 ? texel : std::min(low, texel);
      high = k == 0 ? texel : std::max(high, texel);
    }
    const float v = LoadChannel(job.next.format, job.next.At(x, y), c);
    StoreChannel(job.next.format, std::clamp(v, low, high), job.next.At(x, y), c);
  }
}

}  // namespace warplut::peers
