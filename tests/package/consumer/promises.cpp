// What the runtime promises about NaN and equal bits, checked in a program that is compiled with
// other flags than the library: ends with 1 where a promise is broken, and prints a number of all
// images.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

#include "luts/half.h"
#include "runtime/camera_motion.h"
#include "runtime/color_encoding.h"
#include "runtime/frame_generation.h"
#include "runtime/gates.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"

namespace {

using namespace warplut;

constexpr int kWidth = 70, kHeight = 33;
constexpr std::uint32_t kNanBits = 0x7FC00000u, kInfinityBits = 0x7F800000u;

// A number that the compiler does not know.
float FromBits(std::uint32_t bits) {
  volatile std::uint32_t hidden = bits;
  return std::bit_cast<float>(std::uint32_t{hidden});
}

int broken = 0;
void Expect(bool holds, const char* promise) {
  if (holds) return;
  std::printf("broken: %s\n", promise);
  ++broken;
}

bool IsZero(float x) { return (std::bit_cast<std::uint32_t>(x) & 0x7FFFFFFFu) == 0; }

void CheckHeaders() {
  const float nan = FromBits(kNanBits), infinity = FromBits(kInfinityBits);
  Expect(IsZero(LimitHdr(nan)), "NaN is limited to 0");
  Expect(LimitHdr(infinity) == kLargestHdr, "infinity is limited to the largest half");
  Expect(IsZero(LimitHdr(FromBits(kInfinityBits | 0x80000000u))), "-infinity is limited to 0");
  for (const float width : {0.0f, 0.5f}) {
    Expect(IsZero(Gate(nan, 0.25f, width)), "NaN is beyond a gate");
    Expect(IsZero(Gate(infinity, 0.25f, width)), "infinity is beyond a gate");
    Expect(Gate(0.1f, 0.25f, width) == 1, "0.1 passes a gate");
  }
  Expect(IsZero(InverseDepth(nan)), "a depth of NaN has the inverse 0");
  bool same = true;
  for (unsigned half = 0; half < 0x10000u; ++half) {
    const auto bits = static_cast<std::uint16_t>(half);
    const bool is_nan = (half & 0x7FFFu) > 0x7C00u;
    const std::uint16_t back = FloatToHalf(HalfToFloat(bits));
    same = same && (is_nan ? (back & 0x7FFFu) > 0x7C00u : back == bits);
  }
  Expect(same, "halves are what they were after float");
  SuperResolutionOptions options;
  options.render_width = options.output_width = kWidth;
  options.render_height = options.output_height = kHeight;
  Expect(options.IsValid(), "the defaults are valid");
  options.gate_width = nan;
  Expect(!options.IsValid(), "a gate width of NaN is refused");
  options.gate_width = 0;
  options.parameters.blend_a = nan;
  Expect(!options.IsValid(), "a parameter of NaN is refused");
}

// Exact whatever the compiler does: sums of small multiples of powers of 2, some that are no
// numbers, and subnormals.
float Value(int i, int seed) {
  const unsigned mixed =
      static_cast<unsigned>(i) * 2654435761u + static_cast<unsigned>(seed) * 40503u;
  const unsigned kind = mixed >> 28, code = mixed >> 8 & 0xFFu;
  if (kind == 0) return FromBits(kNanBits);
  if (kind == 1) return FromBits(kInfinityBits | (code & 1u) << 31);
  if (kind == 2) return FromBits(code);
  return static_cast<float>(code) * (1.0f / 256);
}

struct Frame {
  explicit Frame(int seed)
      : color(kWidth, kHeight, PixelFormat::kRgba32F),
        depth(kWidth, kHeight, PixelFormat::kR32F),
        motion(kWidth, kHeight) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const int i = y * kWidth + x;
        for (int c = 0; c < 4; ++c) {
          color.view().Row<float>(y)[4 * x + c] = Value(4 * i + c, seed);
        }
        depth.view().Row<float>(y)[x] = Value(i, seed + 1);
        for (int c = 0; c < 2; ++c)
          motion.view().Row(y)[2 * x + c] = 3 * Value(2 * i + c, seed + 2);
      }
    }
  }

  ImageBuffer color, depth;
  MotionBuffer motion;
};

std::uint64_t hash = 0xCBF29CE484222325u;
void AddImage(const ImageBuffer& image) {
  const ImageView view = image.view();
  bool finite = true;
  for (int y = 0; y < view.height; ++y) {
    for (int i = 0; i < 4 * view.width; ++i) {
      const auto bits = view.Row<std::uint32_t>(y)[i];
      finite = finite && (bits & 0x7FFFFFFFu) < kInfinityBits;
      hash = (hash ^ bits) * 0x100000001B3u;
    }
  }
  Expect(finite, "images of the pipeline are finite");
}

void RunPipeline(ColorEncoding encoding, bool reference) {
  const Frame frames[] = {Frame(1), Frame(5), Frame(9)};
  ThreadPool pool(2);
  SuperResolutionOptions sr_options;
  sr_options.render_width = kWidth;
  sr_options.render_height = kHeight;
  sr_options.output_width = 2 * kWidth;
  sr_options.output_height = 2 * kHeight;
  sr_options.encoding = encoding;
  sr_options.reference = reference;
  SuperResolution sr(sr_options, pool);
  for (const Frame& frame : frames) {
    ImageBuffer out(2 * kWidth, 2 * kHeight, PixelFormat::kRgba32F);
    sr.Process(
        {.color = frame.color.view(), .depth = frame.depth.view(), .motion = frame.motion.view()},
        out.view());
    AddImage(out);
  }
  FrameGenerationOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.encoding = encoding;
  options.reference = reference;
  FrameGeneration generation(options, pool);
  const auto displayed = [&](int i) {
    return DisplayedFrame{frames[i].color.view(), frames[i].depth.view(), frames[i].motion.view()};
  };
  ImageBuffer out(kWidth, kHeight, PixelFormat::kRgba32F);
  generation.Interpolate(displayed(0), displayed(1), 0.25f, out.view());
  AddImage(out);
  generation.Extrapolate(displayed(1), displayed(2), 0.75f, out.view());
  AddImage(out);
}

}  // namespace

int main() {
  CheckHeaders();
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    for (const bool reference : {false, true}) RunPipeline(encoding, reference);
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return broken == 0 ? 0 : 1;
}
