// Errors and times of resampling kernels.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tools/report/kernels/resampling_kernels.h"
#include "train/fit/rollout/trajectory.h"
#include "train/replay/clip.h"

namespace warplut {

// After how many warps the error is looked at.
inline constexpr std::array<int, 2> kErrorWarps = {6, 24};

// Where offsets come from: any, one half, or what a surface of the sequence makes of them.
enum class OffsetSource : std::uint8_t { kRandom, kHalf, kMotion };
inline constexpr OffsetSource kOffsetSources[] = {OffsetSource::kRandom, OffsetSource::kHalf,
                                                  OffsetSource::kMotion};
constexpr const char* Name(OffsetSource source) {
  return source == OffsetSource::kRandom ? "random"
         : source == OffsetSource::kHalf ? "half"
                                         : "motion";
}

// An image and the displacements that it is warped along, for each source; at every one of
// kErrorWarps their sum is zero.
struct KernelProblem {
  Image image;  // luma
  std::array<std::vector<Displacement>, std::size(kOffsetSources)> trajectories;
};

// The reference of the middle frame, its largest centred window of at most `side` pixels. kMotion
// follows the motion of a random surface of the clip from frame to frame, and that of another one
// where it ends; the warp before each of kErrorWarps returns to the start. The same seed gives the
// same problem.
KernelProblem MakeKernelProblem(const Clip& clip, int side, std::uint64_t seed);

// Means over the problems, by kOffsetSources and kErrorWarps.
struct KernelError {
  double loss = 0;  // 1 - SSIM
  double mean_squared_error = 0;
};
using KernelErrors =
    std::array<std::array<KernelError, kErrorWarps.size()>, std::size(kOffsetSources)>;

// Without kProtocolBorder pixels at each edge. The history is stored in `format` after each warp.
// The same bits for any number of threads.
KernelErrors JudgeKernel(const ResamplingKernel& kernel, PixelFormat format,
                         const std::vector<KernelProblem>& problems);

// The Keys parameter with the least mean loss over all sources and both numbers of warps, in float.
// `on_step` is called before each evaluation.
double BestKeysParameter(const std::vector<KernelProblem>& problems,
                         const std::function<void(double share)>& on_step);

// Compares the kernel's result with what it must equal, and a constant image with itself. Empty, or
// a sentence.
std::string CheckKernel(const ResamplingKernel& kernel, PixelFormat format);

// Processor time in milliseconds per megapixel of each kernel, on one thread, another motion at
// every pixel: the median of `repeats` rounds in which each has its turn, after one that does not
// count. `on_round` is called before each round and may throw.
struct KernelTimeOptions {
  int width = 1280, height = 800;
  int repeats = 7;
  std::function<void(int round)> on_round = [](int) {};
};
std::vector<double> TimeKernels(const std::vector<const ResamplingKernel*>& kernels,
                                PixelFormat format, const KernelTimeOptions& options);

}  // namespace warplut
