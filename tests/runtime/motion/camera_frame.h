// Depth and motion of a frame under a moving camera, for the tests of the motion filter.
#pragma once

#include <cmath>
#include <cstring>
#include <random>

#include "runtime/camera_motion.h"
#include "runtime/gates.h"
#include "runtime/image_buffer.h"

namespace warplut {

// A frame whose pixels see random boxes at different depths under a moving camera.
struct CameraFrame {
  CameraFrame(int w, int h)
      : width(w), height(h), depth(w, h, PixelFormat::kR32F), motion(w, h), truth(w, h) {}

  static CameraFrame UnderCamera(int w, int h, unsigned seed = 1) {
    CameraFrame frame(w, h);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    const CameraMotion camera = {
        .c = {0.01, -0.02, 0.015, 0.0008, 0.02, 0.01, -0.01, 0.0003, 0.006, -0.004, 0.0002}};
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        const bool background = (x / 7 + y / 9) % 11 == 0;
        frame.Depth(x, y) = background ? kFarthestDepth : 0.01f + 0.2f * unit(random);
        const auto [mx, my] = camera.At(x, y, InverseDepth(frame.Depth(x, y)), w, h);
        frame.Set(x, y, static_cast<float>(mx), static_cast<float>(my));
      }
    }
    frame.CopyToTruth();
    return frame;
  }

  float& Depth(int x, int y) { return depth.view().Row<float>(y)[x]; }
  void Set(int x, int y, float mx, float my) {
    motion.view().Row(y)[2 * x] = mx;
    motion.view().Row(y)[2 * x + 1] = my;
  }
  void CopyToTruth() {
    for (int y = 0; y < height; ++y) {
      std::memcpy(truth.view().Row(y), motion.view().Row(y),
                  sizeof(float) * 2 * static_cast<std::size_t>(width));
    }
  }
  void Quantise(float step) {
    for (int y = 0; y < height; ++y) {
      for (int i = 0; i < 2 * width; ++i) {
        float& m = motion.view().Row(y)[i];
        m = std::round(m / step) * step;
      }
    }
  }

  int width, height;
  ImageBuffer depth;
  MotionBuffer motion, truth;
};

}  // namespace warplut
