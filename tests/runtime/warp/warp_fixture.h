// Images, motion and filters for the tests of the warp.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "runtime/core/instruction_sets.h"
#include "runtime/core/pixel.h"
#include "runtime/prefilter.h"
#include "runtime/warp.h"
#include "tests/runtime/test_table.h"

namespace warplut {

// An image with `padding` more bytes per row than it needs, filled with 0xA5.
class TestImage {
 public:
  TestImage(int width, int height, PixelFormat format, int padding = 0)
      : stride_(std::ptrdiff_t{width} * BytesPerPixel(format) + padding),
        bytes_(static_cast<std::size_t>(stride_ * height), std::byte{0xA5}),
        width_(width),
        height_(height),
        format_(format) {}

  MutableImageView view() { return {bytes_.data(), width_, height_, stride_, format_}; }
  ImageView view() const { return {bytes_.data(), width_, height_, stride_, format_}; }
  ImageView history() const { return view(); }

  float Get(int x, int y, int c) const { return LoadChannel(format_, view().At(x, y), c); }
  void Set(int x, int y, int c, float value) { StoreChannel(format_, value, view().At(x, y), c); }

  // Random values: 0..255 for RGBA8, else in [-2, 2].
  void Randomise(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> code(0, 255);
    std::uniform_real_distribution<float> value(-2, 2);
    for (int y = 0; y < height_; ++y) {
      for (int i = 0; i < width_ * Channels(format_); ++i) {
        StoreChannel(format_, format_ == PixelFormat::kRgba8 ? code(random) : value(random),
                     view().At(0, y), i);
      }
    }
  }

  void Fill(float value) {
    for (int y = 0; y < height_; ++y) {
      for (int i = 0; i < width_ * Channels(format_); ++i) {
        StoreChannel(format_, value, view().At(0, y), i);
      }
    }
  }

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat format() const { return format_; }
  bool operator==(const TestImage& other) const { return bytes_ == other.bytes_; }

 private:
  std::ptrdiff_t stride_;
  std::vector<std::byte> bytes_;
  int width_;
  int height_;
  PixelFormat format_;
};

class TestMotion {
 public:
  TestMotion(int width, int height, float mx = 0, float my = 0, int padding = 0)
      : row_(2 * width + padding),
        xy_(static_cast<std::size_t>(row_) * height),
        width_(width),
        height_(height) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) Set(x, y, mx, my);
    }
  }

  MotionView view() const {
    return {xy_.data(), width_, height_, std::ptrdiff_t{row_} * static_cast<int>(sizeof(float))};
  }
  const float* At(int x, int y) const { return xy_.data() + y * row_ + 2 * x; }
  void Set(int x, int y, float mx, float my) {
    xy_[static_cast<std::size_t>(y * row_ + 2 * x)] = mx;
    xy_[static_cast<std::size_t>(y * row_ + 2 * x + 1)] = my;
  }

  // Uniform in [-reach, reach]; a sixteenth of the vectors is whole.
  void Randomise(unsigned seed, float reach) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(-reach, reach);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        float mx = value(random);
        float my = value(random);
        if (random() % 16 == 0) {
          mx = std::round(mx);
          my = std::round(my);
        }
        Set(x, y, mx, my);
      }
    }
  }

 private:
  int row_;
  std::vector<float> xy_;
  int width_;
  int height_;
};

// An image as a filter reads it: with its coefficients if the filter has a prefilter. Holds a copy.
class TestHistory {
 public:
  TestHistory(const TestImage& samples, const WarpOptions& options)
      : samples_(samples), coefficients_(samples) {
    const Prefilter prefilter = PrefilterOf(options);
    if (!HasPrefilter(prefilter)) return;
    prefiltered_ = true;
    const int width = samples.width();
    const int height = samples.height();
    coefficients_ = TestImage(width, height, CoefficientFormat(samples.format()), 16);
    SerialExecutor executor;
    PrefilterPass(prefilter, width, height, 1)
        .Apply(samples_.view(), executor, coefficients_.view());
  }

  // The largest |channel| of what is weighed; those that are not finite do not count.
  float Largest() const {
    float largest = 0;
    for (int y = 0; y < coefficients_.height(); ++y) {
      for (int x = 0; x < coefficients_.width(); ++x) {
        for (int c = 0; c < Channels(coefficients_.format()); ++c) {
          const float value = std::abs(coefficients_.Get(x, y, c));
          if (std::isfinite(value)) largest = std::max(largest, value);
        }
      }
    }
    return largest;
  }

  WarpStats WarpTo(const MotionView& motion, const WarpOptions& options, TestImage& out) const {
    if (prefiltered_) return Warp(Image(), motion, options, out.view());
    return Warp(samples_.view(), motion, options, out.view());
  }
  void WarpRowsTo(const MotionView& motion, const WarpOptions& options, int first_row, int last_row,
                  TestImage& out) const {
    if (prefiltered_) {
      WarpRows(Image(), motion, options, first_row, last_row, out.view());
    } else {
      WarpRows(samples_.view(), motion, options, first_row, last_row, out.view());
    }
  }
  void ReferenceTo(const MotionView& motion, const WarpOptions& options, TestImage& out) const {
    if (prefiltered_) {
      WarpReference(Image(), motion, options, out.view());
    } else {
      WarpReference(samples_.view(), motion, options, out.view());
    }
  }

 private:
  PrefilteredImage Image() const { return {samples_.view(), coefficients_.view()}; }

  TestImage samples_;
  TestImage coefficients_;
  bool prefiltered_ = false;
};

// Every filter of the registry. Those that need a table come with both lookups, each also with a
// table that has a prefilter, and with tables of more taps.
struct TestFilter {
  std::string name;
  WarpOptions options;
};

inline std::vector<TestFilter> TestFilters(const Table* table) {
  static const TestTable stored_spline = MakeSplineTable(TableFormat::kI16, kOMomsK / 2);
  static const Table spline_table(stored_spline.view());
  static const Table wide_tables[] = {
      Table(MakeWideTable(TableFormat::kI16, Footprint::k24).view()),
      Table(MakeWideTable(TableFormat::kI16, Footprint::k36).view())};
  std::vector<TestFilter> filters;
  for (const FilterInfo& info : kFilters) {
    WarpOptions options;
    options.filter = info.filter;
    if (info.needs_a) options.keys_a = -0.62f;
    if (info.needs_k) options.spline_k = static_cast<float>(kOMomsK);
    if (!info.needs_table) {
      filters.push_back({info.name, options});
      continue;
    }
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      options.lookup = lookup;
      options.table = table;
      filters.push_back({std::string(info.name) + " " + Name(lookup), options});
      options.table = &spline_table;
      filters.push_back({std::string("prefiltered ") + info.name + " " + Name(lookup), options});
      for (const Table& wide : wide_tables) {
        options.table = &wide;
        filters.push_back({std::string(info.name) + " " +
                               std::to_string(TapCount(wide.footprint())) + " " + Name(lookup),
                           options});
      }
    }
  }
  return filters;
}

}  // namespace warplut
