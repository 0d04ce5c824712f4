#include "tools/report/kernels/kernel_scores.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <span>

#include "runtime/image_buffer.h"
#include "tools/bench/bench_scene.h"
#include "tools/bench/timing.h"
#include "tools/judge/images/filter_family.h"
#include "tools/judge/images/image_set.h"
#include "tools/judge/images/plane.h"
#include "train/fit/random.h"
#include "train/fit/rivals/golden_section.h"
#include "train/metrics/luma.h"
#include "train/metrics/psnr.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

// Offsets between two nodes may fall to either; of a thousand pixels so many may differ.
constexpr double kDifferingShare = 0.002;
constexpr float kCheckCodes = 1.01f;  // code values that count as rounding
// The size of the images of CheckKernel, and the rows that slow kernels are timed on.
constexpr int kCheckWidth = 203, kCheckHeight = 64;
constexpr int kSlowRows = 4;

// The motion of a surface from frame to frame, of one after the other.
class SurfaceMotion {
 public:
  SurfaceMotion(const Clip& clip, std::uint64_t seed) : clip_(clip), random_(seed) {}

  Displacement Next() {
    if (frame_ >= clip_.frames.size() || clip_.frames[frame_].cut) Restart();
    const MotionView motion = clip_.frames[frame_].reference_motion.view();
    const int column = static_cast<int>(std::floor(x_)), row = static_cast<int>(std::floor(y_));
    if (column < 0 || row < 0 || column >= motion.width || row >= motion.height) {
      Restart();
      return Next();
    }
    const float* m = motion.Row(row) + std::ptrdiff_t{2} * column;
    ++frame_;
    if (!std::isfinite(m[0]) || !std::isfinite(m[1])) {
      frame_ = clip_.frames.size();
      return {};
    }
    x_ += m[0];
    y_ += m[1];
    return {m[0], m[1]};
  }

 private:
  // The first frame has no motion of its own.
  void Restart() {
    frame_ = 1;
    while (frame_ + 1 < clip_.frames.size() && clip_.frames[frame_].cut) ++frame_;
    const MotionView motion = clip_.frames[frame_].reference_motion.view();
    x_ = random_.Below(motion.width) + 0.5;
    y_ = random_.Below(motion.height) + 0.5;
  }

  const Clip& clip_;
  Random random_;
  std::size_t frame_ = static_cast<std::size_t>(-1);
  double x_ = 0, y_ = 0;
};

// The fraction of a displacement, with the whole part that keeps the sum within a pixel.
double Within(double displacement, double sum) {
  const double fraction = displacement - std::floor(displacement);
  return sum + fraction >= 1 ? fraction - 1 : fraction;
}

std::vector<Displacement> FollowMotion(const Clip& clip, std::uint64_t seed) {
  SurfaceMotion motion(clip, seed);
  std::vector<Displacement> trajectory;
  double x = 0, y = 0;
  for (const int warps : kErrorWarps) {
    while (static_cast<int>(trajectory.size()) + 1 < warps) {
      const Displacement m = motion.Next();
      trajectory.push_back({Within(m.x, x), Within(m.y, y)});
      x += trajectory.back().x;
      y += trajectory.back().y;
    }
    trajectory.push_back({-x, -y});
    x = y = 0;
  }
  return trajectory;
}

KernelError ErrorOf(const Image& warped, const Image& image) {
  return {
      .loss =
          1 - Ssim(InnerPlane(image, kProtocolBorder)).Mean(InnerPlane(warped, kProtocolBorder)),
      .mean_squared_error = MeanSquaredError(warped, image, kProtocolBorder)};
}

KernelErrors JudgeFilter(const ProtocolFilter& filter, const std::vector<KernelProblem>& problems) {
  constexpr std::size_t kSources = std::size(kOffsetSources);
  std::vector<std::array<KernelError, kErrorWarps.size()>> errors(problems.size() * kSources);
  tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t item) {
    const KernelProblem& problem = problems[item / kSources];
    const std::span<const Displacement> trajectory = problem.trajectories[item % kSources];
    Image image = problem.image;
    std::size_t begin = 0;
    for (std::size_t w = 0; w < kErrorWarps.size(); ++w) {
      const auto end = static_cast<std::size_t>(kErrorWarps[w]);
      image = WarpAlong(filter, trajectory.subspan(begin, end - begin), image);
      errors[item][w] = ErrorOf(image, problem.image);
      begin = end;
    }
  });
  KernelErrors means{};
  for (std::size_t item = 0; item < errors.size(); ++item) {
    for (std::size_t w = 0; w < kErrorWarps.size(); ++w) {
      KernelError& mean = means[item % kSources][w];
      mean.loss += errors[item][w].loss / static_cast<double>(problems.size());
      mean.mean_squared_error +=
          errors[item][w].mean_squared_error / static_cast<double>(problems.size());
    }
  }
  return means;
}

Image ConstantImage(int width, int height) {
  Image image(width, height, 3);
  std::fill(image.data.begin(), image.data.end(), 0.7f);
  return image;
}

}  // namespace

KernelProblem MakeKernelProblem(const Clip& clip, int side, std::uint64_t seed) {
  const ClipFrame& middle = clip.frames[clip.frames.size() / 2];
  KernelProblem problem;
  problem.image = CenterCrop(Luma(ToImage(middle.reference.view())), side);
  problem.trajectories = {MakeTrajectory(Offsets::kRandom, kErrorWarps, kProtocolSteps, seed),
                          MakeTrajectory(Offsets::kHalf, kErrorWarps, kProtocolSteps, seed),
                          FollowMotion(clip, seed)};
  return problem;
}

KernelErrors JudgeKernel(const ResamplingKernel& kernel, PixelFormat format,
                         const std::vector<KernelProblem>& problems) {
  return JudgeFilter(AsProtocolFilter(kernel, format), problems);
}

double BestKeysParameter(const std::vector<KernelProblem>& problems,
                         const std::function<void(double share)>& on_step) {
  const FilterFamily& keys = *FindFamily(kBestKeys);
  int evaluation = 0;
  const auto score = [&](double a) {
    on_step(static_cast<double>(evaluation++) / keys.Evaluations());
    const ProtocolFilter filter = keys.make(a);
    double sum = 0;
    for (const auto& source : JudgeFilter(filter, problems)) {
      for (const KernelError& error : source) sum -= error.loss;
    }
    return sum;
  };
  return keys.Best(score).at;
}

std::string CheckKernel(const ResamplingKernel& kernel, PixelFormat format) {
  const BenchScene scene({.width = kCheckWidth, .height = kCheckHeight, .format = format});
  const DisplayedFrame frame = scene.Displayed();
  ImageBuffer out(kCheckWidth, kCheckHeight, format), expected(kCheckWidth, kCheckHeight, format);
  if (kernel.equal_to) {
    WarpReference(frame.color, frame.motion, *kernel.equal_to, expected.view());
    kernel.prepare(frame.color, frame.motion, out.view())();
    const double share = FlippedShare(out.view(), expected.view(), kCheckCodes);
    if (share > kDifferingShare) {
      return fmt::format("{} differs from what it should equal at {:.2g} % of the pixels",
                         kernel.name, 100 * share);
    }
  }
  const ImageBuffer constant = ToBuffer(ConstantImage(kCheckWidth, kCheckHeight), format);
  kernel.prepare(constant.view(), frame.motion, out.view())();
  if (FlippedShare(out.view(), constant.view(), kCheckCodes) > 0) {
    return fmt::format("{} does not keep a constant image", kernel.name);
  }
  return {};
}

std::vector<double> TimeKernels(const std::vector<const ResamplingKernel*>& kernels,
                                PixelFormat format, const KernelTimeOptions& options) {
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const BenchScene scene({.width = options.width, .height = options.height, .format = format});
  const DisplayedFrame frame = scene.Displayed();
  ImageBuffer result(options.width, options.height, format);
  std::vector<ResamplingKernel::Call> calls;
  std::vector<double> megapixels;
  for (const ResamplingKernel* kernel : kernels) {
    const int rows = kernel->slow ? std::min(kSlowRows, options.height) : options.height;
    ImageView history = frame.color;
    MotionView motion = frame.motion;
    MutableImageView out = result.view();
    history.height = out.height = motion.height = rows;
    calls.push_back(kernel->prepare(history, motion, out));
    megapixels.push_back(1e-6 * options.width * rows);
  }
  std::vector<std::vector<double>> times(kernels.size());
  for (int round = -1; round < options.repeats; ++round) {
    options.on_round(round + 1);
    for (std::size_t k = 0; k < calls.size(); ++k) {
      const double time = Milliseconds(calls[k]) / megapixels[k];
      if (round >= 0) times[k].push_back(time);
    }
  }
  cv::setNumThreads(threads);
  std::vector<double> medians;
  for (const std::vector<double>& of_one : times) medians.push_back(Summarise(of_one).median);
  return medians;
}

}  // namespace warplut
