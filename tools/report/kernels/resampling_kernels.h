// The kernels that the report compares: those of the runtime, others in plain C++, and OpenCV's.
//
// All of them make out(p) = history at p - m(p), motion m in pixels (runtime/warp.h). Those in
// plain C++ turn the history into floats with a border first, which counts in their time, and then
// go pixel by pixel without vector instructions of their own: their times compare with each other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/warp.h"
#include "tools/judge/images/warp_protocol.h"
#include "tools/report/report_inputs.h"

namespace warplut {

// Kernels of one family are written with the same care, so that their times compare. OpenCV's are
// vectorised as the runtime's.
enum class KernelFamily : std::uint8_t { kRuntime, kPlain, kOpenCv };

constexpr const char* Name(KernelFamily family) {
  return family == KernelFamily::kRuntime ? "runtime"
         : family == KernelFamily::kPlain ? "plain C++"
                                          : "OpenCV";
}

struct ResamplingKernel {
  std::string name;
  KernelFamily family = KernelFamily::kRuntime;
  std::string reads;  // "16 texels", "9 fetches"
  bool slow = false;  // seconds for a megapixel: timed on few pixels
  // Does what comes before the warp and is not timed (OpenCV's maps), and returns the warp. The
  // views outlive it. History and output have one format, of 4 channels or kR32F.
  using Call = std::function<void()>;
  std::function<Call(const ImageView& history, const MotionView& motion,
                     const MutableImageView& out)>
      prepare;
  // What its result must equal, but for rounding and for offsets that lie between two nodes;
  // nothing for kernels that stand alone.
  std::optional<WarpOptions> equal_to;

  bool Takes(PixelFormat format) const {
    return family != KernelFamily::kOpenCv || format != PixelFormat::kRgba16F;
  }
};

// The number of nodes per axis of the tables that are compared.
inline constexpr int kComparedNodes[] = {8, 16, 32, 64};

// Bilinear, Catmull-Rom, Keys with parameter `keys_a`, and the tables; then the kernels that the
// runtime has not. Without a fit in `lut` the exact MLP and the tables of other than kNodes nodes
// are left out. `lut` outlives the kernels.
std::vector<ResamplingKernel> ResamplingKernels(const ReportLut& lut, float keys_a);

// A kernel as the protocols take it: one value for each pixel in float, rounded to `format` after
// each warp, as a history of that format would be.
ProtocolFilter AsProtocolFilter(const ResamplingKernel& kernel, PixelFormat format);

}  // namespace warplut
