#include "datasets/encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/error.h"

namespace warplut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kBase = 255;
constexpr std::int64_t kBase3 = 255LL * 255 * 255;
constexpr double kCodes = kBase * static_cast<double>(kBase3);  // code of 1

[[noreturn]] void Refuse(const std::string& what, const Image& image, std::size_t pixel,
                         double found, const char* expected) {
  const auto width = static_cast<std::size_t>(image.width);
  throw Error(fmt::format("'{}': pixel ({}, {}) is {:.7g}; expected {}", what, pixel % width,
                          pixel / width, found, expected));
}

double Stored(const Image& stored, std::size_t pixel, Encoding encoding) {
  if (encoding == Encoding::kFloat) return stored.data[pixel];
  std::array<std::uint8_t, 4> code;
  for (std::size_t c = 0; c < 4; ++c) {
    code[c] = static_cast<std::uint8_t>(std::lround(double{stored.data[4 * pixel + c]} * kBase));
  }
  return UnpackRgba8Base255(code);
}

Image StoredLike(const Image& image, Encoding encoding) {
  return Image(image.width, image.height, encoding == Encoding::kFloat ? 1 : 4);
}

void Store(double v, Encoding encoding, std::size_t pixel, const std::string& what, Image* stored) {
  if (encoding == Encoding::kFloat) {
    stored->data[pixel] = static_cast<float>(v);
    return;
  }
  // Scale and bias may take an end of the range just past it.
  constexpr double kHalfCode = 0.5 / kCodes;
  if (!(v >= -kHalfCode && v <= 1 + kHalfCode)) {
    Refuse(what, *stored, pixel, v, "a code from 0 to 1 after scale and bias");
  }
  const std::array<std::uint8_t, 4> code = PackRgba8Base255(v);
  for (std::size_t c = 0; c < 4; ++c) {
    stored->data[4 * pixel + c] = static_cast<float>(code[c] / kBase);
  }
}

// Depth of the value z as stated in the header, z in [0, 1] if hyperbolic.
double DepthOf(double z, const DepthStream& s) {
  switch (s.kind) {
    case DepthKind::kLinear:
      return z / s.far;
    case DepthKind::kForward:
      return s.near / (s.far - z * (s.far - s.near));
    case DepthKind::kReversed:
      break;
  }
  if (std::isinf(s.far)) return 1 / z;
  return s.near / (s.near + z * (s.far - s.near));
}

// The inverse; d in [0, inf].
double ValueOf(double d, const DepthStream& s) {
  double z = 0;
  switch (s.kind) {
    case DepthKind::kLinear:
      if (s.encoding == Encoding::kRgba8Base255) d = std::min(d, 1.0);
      return d * s.far;
    case DepthKind::kForward:
      z = (s.far - s.near / d) / (s.far - s.near);
      break;
    case DepthKind::kReversed:
      z = std::isinf(s.far) ? 1 / d : (s.near / d - s.near) / (s.far - s.near);
      break;
  }
  return std::fmin(std::fmax(z, 0), 1);
}

// The stated value or beyond it; within 1e-6 of it, so that half floats of it hit.
bool IsBackground(double z, const DepthStream& s) {
  if (!s.background) return false;
  const double slack = 1e-6 * std::max(1.0, std::abs(*s.background));
  return s.kind == DepthKind::kReversed ? z <= *s.background + slack : z >= *s.background - slack;
}

bool IsOneOf(const std::vector<double>& values, double v) {
  constexpr double kSame = 1e-6;
  return std::any_of(values.begin(), values.end(), [&](double value) {
    return std::abs(v - value) <= kSame * std::max(1.0, std::abs(value));
  });
}

// Pixels per unit of the stream, with the signs of the conversion.
double PixelsPerUnit(const MotionStream& s, int c, const Image& image) {
  double scale = 1;
  if (s.units != MotionUnits::kPixels) scale = c == 0 ? image.width : image.height;
  if (s.units == MotionUnits::kNdc) scale /= 2;
  if (c == 1 && s.y == YAxis::kUp) scale = -scale;
  if (s.direction == MotionDirection::kCurrentToPrevious) scale = -scale;
  return scale;
}

}  // namespace

std::array<std::uint8_t, 4> PackRgba8Base255(double v) {
  std::int64_t code = std::llround(v * kCodes);
  std::array<std::uint8_t, 4> bytes;
  std::int64_t unit = kBase3;
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(code / unit);
    code %= unit;
    unit /= 255;
  }
  return bytes;
}

double UnpackRgba8Base255(const std::array<std::uint8_t, 4>& code) {
  std::int64_t sum = 0;
  for (const std::uint8_t byte : code) sum = sum * 255 + byte;
  return static_cast<double>(sum) / kCodes;
}

Image DecodeDepth(const Image& stored, const DepthStream& stream, const std::string& what) {
  Image depth(stored.width, stored.height, 1);
  const std::size_t pixels = stored.pixels();
  for (std::size_t i = 0; i < pixels; ++i) {
    double z = stream.scale * Stored(stored, i, stream.encoding) + stream.bias;
    if (IsBackground(z, stream)) {
      depth.data[i] = std::isinf(stream.far) ? std::numeric_limits<float>::infinity() : 1.0F;
      continue;
    }
    if (stream.kind != DepthKind::kLinear) {
      if (!(z >= -kHyperbolicSlack && z <= 1 + kHyperbolicSlack)) {
        Refuse(what, stored, i, z, "a depth buffer value from 0 to 1");
      }
      z = std::fmin(std::fmax(z, 0), 1);
    } else if (!(z >= 0)) {
      Refuse(what, stored, i, z, "a view depth of 0 or more");
    }
    depth.data[i] = static_cast<float>(DepthOf(z, stream));
  }
  return depth;
}

Image EncodeDepth(const Image& depth, const DepthStream& stream, const std::string& what) {
  Image stored = StoredLike(depth, stream.encoding);
  const std::size_t pixels = depth.pixels();
  for (std::size_t i = 0; i < pixels; ++i) {
    const double d = depth.data[i];
    if (!(d >= 0)) Refuse(what, depth, i, d, "a depth of 0 or more");
    Store((ValueOf(d, stream) - stream.bias) / stream.scale, stream.encoding, i, what, &stored);
  }
  return stored;
}

void DecodeMotion(const Image& stored, const MotionStream& stream, int c, const std::string& what,
                  Image* motion) {
  const std::size_t k = static_cast<std::size_t>(c);
  const double pixels_per_unit = PixelsPerUnit(stream, c, stored);
  const std::size_t pixels = stored.pixels();
  for (std::size_t i = 0; i < pixels; ++i) {
    const double v = stream.scale[k] * Stored(stored, i, stream.encoding) + stream.bias[k];
    float m = static_cast<float>(v * pixels_per_unit);
    if (stream.invalid) {
      if (!std::isfinite(m) || IsOneOf(stream.invalid->values, v)) m = std::nanf("");
    } else if (!std::isfinite(m)) {
      Refuse(what, stored, i, v, "a finite motion, or the field 'invalid'");
    }
    motion->data[2 * i + k] = m;
  }
}

void ClearInvalid(Image* motion) {
  for (std::size_t i = 0; i < motion->data.size(); i += 2) {
    float* m = &motion->data[i];
    if (std::isnan(m[0]) || std::isnan(m[1])) m[0] = m[1] = 0;
  }
}

Image EncodeMotion(const Image& motion, const MotionStream& stream, int c,
                   const std::string& what) {
  Image stored = StoredLike(motion, stream.encoding);
  const std::size_t k = static_cast<std::size_t>(c);
  const double pixels_per_unit = PixelsPerUnit(stream, c, motion);
  const std::size_t pixels = motion.pixels();
  for (std::size_t i = 0; i < pixels; ++i) {
    const double m = motion.data[2 * i + k];
    if (!std::isfinite(m)) Refuse(what, motion, i, m, "a finite motion");
    Store((m / pixels_per_unit - stream.bias[k]) / stream.scale[k], stream.encoding, i, what,
          &stored);
  }
  return stored;
}

}  // namespace warplut
