#include "datasets/sequence/forward_flow.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace warplut {
namespace {

constexpr float kReach = 0.75F;
constexpr float kUnseen = std::numeric_limits<float>::infinity();

// The sample that arrived at a pixel: how far it is from the eye, and from the pixel's centre.
struct Arrival {
  float depth = kUnseen;
  float distance = kUnseen;
  bool there = false;
};

class Splat {
 public:
  Splat(const Image& flow, const Image& depth)
      : flow_(flow), depth_(depth), motion_(flow.width, flow.height, 2), arrivals_(flow.pixels()) {
    for (float& value : motion_.data) value = std::nanf("");
  }

  Image Run() {
    for (int y = 0; y < flow_.height; ++y) {
      for (int x = 0; x < flow_.width; ++x) Write(x, y);
    }
    FillHoles();
    return std::move(motion_);
  }

 private:
  float DepthAt(int x, int y) const {
    const float depth = depth_.empty() ? 0.0F : depth_.at(x, y);
    return std::isnan(depth) ? kUnseen : depth;
  }

  void Write(int x, int y) {
    const float mx = flow_.at(x, y, 0), my = flow_.at(x, y, 1);
    const float to_x = static_cast<float>(x) + mx, to_y = static_cast<float>(y) + my;
    const auto width = static_cast<float>(flow_.width), height = static_cast<float>(flow_.height);
    if (!(to_x > -1 && to_y > -1 && to_x < width && to_y < height)) return;
    const float depth = DepthAt(x, y);
    for (int j = static_cast<int>(std::floor(to_y)), last_j = j + 1; j <= last_j; ++j) {
      for (int i = static_cast<int>(std::floor(to_x)), last_i = i + 1; i <= last_i; ++i) {
        const float dx = std::abs(to_x - static_cast<float>(i));
        const float dy = std::abs(to_y - static_cast<float>(j));
        if (i < 0 || j < 0 || i >= flow_.width || j >= flow_.height) continue;
        if (dx > kReach || dy > kReach) continue;
        const float distance = dx * dx + dy * dy;
        Arrival& arrival = arrivals_[motion_.Index(i, j) / 2];
        const bool wins = !arrival.there || depth < arrival.depth ||
                          (depth == arrival.depth && distance < arrival.distance);
        if (!wins) continue;
        arrival = {depth, distance, true};
        motion_.at(i, j, 0) = mx;
        motion_.at(i, j, 1) = my;
      }
    }
  }

  // Larger is more of a background.
  float Farness(std::size_t pixel) const {
    if (!depth_.empty()) return arrivals_[pixel].depth;
    return -std::hypot(motion_.data[2 * pixel], motion_.data[2 * pixel + 1]);
  }

  // From the nearest pixels to the left, to the right, above and below that are no holes.
  void FillHoles() {
    const auto seen = arrivals_;
    const auto at = [&](int x, int y) { return motion_.Index(x, y) / 2; };
    for (int y = 0; y < flow_.height; ++y) {
      for (int x = 0; x < flow_.width; ++x) {
        const std::size_t hole = at(x, y);
        if (seen[hole].there) continue;
        std::size_t best = hole;
        const auto look = [&](int dx, int dy) {
          int i = x + dx, j = y + dy;
          while (i >= 0 && j >= 0 && i < flow_.width && j < flow_.height) {
            const std::size_t pixel = at(i, j);
            if (seen[pixel].there) {
              if (best == hole || Farness(pixel) > Farness(best)) best = pixel;
              return;
            }
            i += dx;
            j += dy;
          }
        };
        look(-1, 0);
        look(1, 0);
        look(0, -1);
        look(0, 1);
        if (best == hole) continue;
        motion_.data[2 * hole] = motion_.data[2 * best];
        motion_.data[2 * hole + 1] = motion_.data[2 * best + 1];
      }
    }
  }

  const Image& flow_;
  const Image& depth_;
  Image motion_;
  std::vector<Arrival> arrivals_;
};

}  // namespace

Image MotionOfForwardFlow(const Image& flow, const Image& depth) {
  return Splat(flow, depth).Run();
}

}  // namespace warplut
