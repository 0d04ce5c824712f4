#include "runtime/dense_rendering.h"

#include <vector>

#include "runtime/configuration/pipeline_check.h"
#include "runtime/core/band.h"
#include "runtime/core/image_check.h"
#include "runtime/core/pixel.h"
#include "runtime/dense/dense_job.h"
#include "runtime/pipeline.h"
#include "runtime/warp.h"

namespace warplut {
namespace {

// Offsets of the samples of static pixels, in eighths of a pixel: the rotated grid of 4 x MSAA.
constexpr float kEighth = 0.125f;
constexpr float kStaticOffsets[kSubframesPerCycle][2] = {{-1, -3}, {3, -1}, {-3, 1}, {1, 3}};

constexpr int kBandRowsOfBlocks = kBandRows / kBlockSize;
static_assert(kBandRows % kBlockSize == 0);

// A number of 32 bits without visible structure: the finalizer of MurmurHash3.
std::uint32_t Mixed(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85EBCA6Bu;
  x = (x ^ (x >> 13)) * 0xC2B2AE35u;
  return x ^ (x >> 16);
}

float LimitColor(float value) { return IsFinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f; }

}  // namespace

bool DenseOptions::IsValid(std::string* why) const {
  const auto fits = [](int size) { return size >= 2 && size <= kLargestSize && size % 2 == 0; };
  if (!fits(width) || !fits(height)) {
    return Refuse({"The displayed size is ", SizeName(width, height), "; even numbers of 2 to ",
                   std::to_string(kLargestSize), " were expected."},
                  why);
  }
  if (motion_radius < 0 || motion_radius > kLargestMotionRadius) {
    return Refuse({"The motion radius is ", std::to_string(motion_radius), "; expected 0 to ",
                   std::to_string(kLargestMotionRadius), "."},
                  why);
  }
  if (window < 1 || window > kSubframesPerCycle) {
    return Refuse({"The window is ", std::to_string(window), "; expected 1 to ",
                   std::to_string(kSubframesPerCycle), "."},
                  why);
  }
  return CheckPart("temporally dense rendering", kPipeline.peers, why) &&
         CheckPart("the reference versions of the passes", kPipeline.reference || !reference,
                   why) &&
         parameters.IsValid(why);
}

struct DenseRendering::State {
  State(const DenseOptions& wanted, Executor& runner)
      : options(wanted),
        executor(runner),
        motion(wanted.width, wanted.height),
        orders(static_cast<std::size_t>(wanted.width / 2) * (wanted.height / 2)),
        counts(static_cast<std::size_t>(wanted.width) * wanted.height),
        workers(static_cast<std::size_t>(runner.Threads())) {
    for (ImageBuffer& image : samples) image = ColorBuffer();
    for (ImageBuffer& image : displayed) image = ColorBuffer();
    for (auto& worker : workers) {
      worker.resize(static_cast<std::size_t>(kBandRows + 2 * options.motion_radius) *
                    options.width);
    }
    Reset();
  }

  ImageBuffer ColorBuffer() const { return {options.width, options.height, PixelFormat::kRgba32F}; }
  int place() const { return static_cast<int>(subframe % kSubframesPerCycle); }
  std::uint32_t cycle() const { return subframe / kSubframesPerCycle; }

  void Reset() {
    subframe = 0;
    has_before = false;
    std::fill(counts.begin(), counts.end(), std::uint8_t{0});
    const BlockOrder order = ChooseOrder(options.order, options.parameters, 0, 0, 0);
    std::fill(orders.begin(), orders.end(), order);
  }

  dense::DenseJob Job() {
    return {options,
            cycle(),
            place(),
            has_before,
            orders.data(),
            {samples[0].view(), samples[1].view(), samples[2].view(), samples[3].view()},
            motion.view(),
            displayed[1].view(),
            displayed[0].view(),
            counts.data()};
  }

  void StoreSamples(const Subframe& from, int block_y);
  void ChooseOrders(const dense::DenseJob& job, int block_y);

  DenseOptions options;
  Executor& executor;
  std::uint32_t subframe = 0;  // since the last reset: the next one
  bool has_before = false;
  ImageBuffer samples[kSubframesPerCycle];
  ImageBuffer displayed[2];  // now, before
  MotionBuffer motion;
  std::vector<BlockOrder> orders;
  std::vector<std::uint8_t> counts;
  std::vector<std::vector<dense::Motion>> workers;
};

// Where the samples of a row of blocks belong; all pixels of the blocks without a frame before, so
// that each of them has a motion.
inline void DenseRendering::State::StoreSamples(const Subframe& from, int block_y) {
  const PixelFormat format = from.color.format;
  const float scale = 1 / ChannelScale(format);
  const MutableImageView newest = samples[cycle() % kSubframesPerCycle].view();
  for (int block_x = 0; block_x < options.width / 2; ++block_x) {
    const BlockOrder order = orders[static_cast<std::size_t>(block_y) * (options.width / 2) +
                                    static_cast<std::size_t>(block_x)];
    const int pixel = PlaceInOrder(order, place());
    const void* color = from.color.At(block_x, block_y);
    const float* m = from.motion.Row(block_y) + 2 * std::ptrdiff_t{block_x};
    const bool moves = IsFinite(m[0]) && IsFinite(m[1]);
    for (int i = 0; i < kSubframesPerCycle; ++i) {
      const int x = 2 * block_x + i % 2, y = 2 * block_y + i / 2;
      if (i != pixel && has_before) continue;
      float* to = motion.view().Row(y) + 2 * std::ptrdiff_t{x};
      for (int c = 0; c < 2; ++c) {
        to[c] = moves ? std::clamp(m[c], -dense::kNoHistory, dense::kNoHistory) : dense::kNoHistory;
      }
      if (i != pixel) continue;
      float* sample = newest.Row<float>(y) + 4 * std::ptrdiff_t{x};
      for (int c = 0; c < 3; ++c) sample[c] = LimitColor(LoadChannel(format, color, c) * scale);
    }
  }
}

inline void DenseRendering::State::ChooseOrders(const dense::DenseJob& job, int block_y) {
  const int columns = options.width / 2;
  for (int block_x = 0; block_x < columns; ++block_x) {
    const dense::Motion m = dense::LongestMotion(job, 2 * block_x, 2 * block_y, 2 * block_x + 1,
                                                 2 * block_y + 1, options.motion_radius);
    const auto i = static_cast<std::size_t>(block_y) * columns + static_cast<std::size_t>(block_x);
    const std::uint32_t random = Mixed(static_cast<std::uint32_t>(i) ^ Mixed(job.cycle));
    orders[i] = ChooseOrder(options.order, options.parameters, m.x, m.y, random);
  }
}

DenseRendering::DenseRendering(const DenseOptions& options, Executor& executor)
    : state_(std::make_unique<State>(options, executor)) {}
DenseRendering::~DenseRendering() = default;

BlockOrder DenseRendering::Order(int x, int y) const {
  return state_->orders[static_cast<std::size_t>(y) * (state_->options.width / 2) +
                        static_cast<std::size_t>(x)];
}

DenseSample DenseRendering::Next(int x, int y) const {
  const int pixel = PlaceInOrder(Order(x, y), state_->place());
  DenseSample sample = {2 * x + pixel % 2, 2 * y + pixel / 2};
  const auto i = static_cast<std::size_t>(sample.y) * state_->options.width + sample.x;
  if (state_->counts[i] > 0 && state_->options.window > 1) {
    const float* offset = kStaticOffsets[state_->cycle() % kSubframesPerCycle];
    sample.dx = kEighth * offset[0];
    sample.dy = kEighth * offset[1];
  }
  return sample;
}

bool DenseRendering::IsProcessable(const Subframe& subframe, const MutableImageView& out,
                                   std::string* why) const {
  const int width = state_->options.width, height = state_->options.height;
  return CheckColor("The colour", subframe.color, width / 2, height / 2, why) &&
         CheckMotion("The motion", subframe.motion, width / 2, height / 2, why) &&
         CheckColor("The output", out, width, height, why);
}

void DenseRendering::Process(const Subframe& subframe, const MutableImageView& out) {
  const FloatEnvironment environment;
  State& s = *state_;
  if (subframe.cut) {
    s.has_before = false;
    std::fill(s.counts.begin(), s.counts.end(), std::uint8_t{0});
  }
  const int block_rows = s.options.height / 2;
  ForEachBand(s.executor, block_rows, kBandRowsOfBlocks, s.workers, [&](const Band& band, auto&) {
    for (int y = band.first; y < band.last; ++y) s.StoreSamples(subframe, y);
  });
  const dense::DenseJob job = s.Job();
  const float scale = ChannelScale(out.format);
  ForEachBand(s.executor, s.options.height, kBandRows, s.workers,
              [&](const Band& band, std::vector<dense::Motion>& longest) {
                if (kPipeline.reference && s.options.reference) {
                  ComposeRowsReference(job, band.first, band.last);
                } else {
                  ComposeRows(job, band.first, band.last, longest.data());
                }
                for (int y = band.first; y < band.last; ++y) {
                  const float* from = job.displayed.Row<float>(y);
                  for (int x = 0; x < s.options.width; ++x) {
                    for (int c = 0; c < 4; ++c) {
                      StoreChannel(out.format, from[4 * x + c] * scale, out.At(x, y), c);
                    }
                  }
                }
              });
  if (s.place() == kSubframesPerCycle - 1) {
    ForEachBand(s.executor, block_rows, kBandRowsOfBlocks, s.workers, [&](const Band& band, auto&) {
      for (int y = band.first; y < band.last; ++y) s.ChooseOrders(job, y);
    });
  }
  std::swap(s.displayed[0], s.displayed[1]);
  s.has_before = true;
  ++s.subframe;
}

void DenseRendering::Reset() { state_->Reset(); }

std::size_t DenseRendering::MemoryBytes() const {
  std::size_t bytes = state_->motion.bytes() + state_->orders.size() + state_->counts.size();
  for (const ImageBuffer& image : state_->samples) bytes += image.bytes();
  for (const ImageBuffer& image : state_->displayed) bytes += image.bytes();
  for (const auto& worker : state_->workers) bytes += worker.size() * sizeof(dense::Motion);
  return bytes;
}

}  // namespace warplut
