#include "tools/report/kernels/resampling_kernels.h"

#include <fmt/format.h>

#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "luts/quantize/quantize.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/prefilter.h"
#include "tools/judge/images/protocol_filter.h"
#include "tools/report/kernels/plain_samplers.h"
#include "tools/table_format.h"

namespace warplut {
namespace {

constexpr Lookup kLookups[] = {Lookup::kNearest, Lookup::kBilinear};

ResamplingKernel RuntimeKernel(std::string name, std::string reads, const WarpOptions& options,
                               std::shared_ptr<const Table> table = nullptr) {
  return {.name = std::move(name),
          .family = KernelFamily::kRuntime,
          .reads = std::move(reads),
          .prepare = [options, table](const ImageView& history, const MotionView& motion,
                                      const MutableImageView& out) -> ResamplingKernel::Call {
            const Prefilter prefilter = PrefilterOf(options);
            if (!HasPrefilter(prefilter)) return [=] { Warp(history, motion, options, out); };
            // The prefilter is part of what the kernel costs.
            struct Coefficients {
              SerialExecutor executor;
              PrefilterPass pass;
              ImageBuffer image;
            };
            const auto coefficients = std::make_shared<Coefficients>(Coefficients{
                {},
                PrefilterPass(prefilter, history.width, history.height, 1),
                ImageBuffer(history.width, history.height, CoefficientFormat(history.format))});
            return [=] {
              coefficients->pass.Apply(history, coefficients->executor, coefficients->image.view());
              Warp(PrefilteredImage{history, std::as_const(coefficients->image).view()}, motion,
                   options, out);
            };
          },
          .equal_to = options};
}

template <class Sampler>
ResamplingKernel PlainKernel(std::string name, std::string reads, Sampler sampler,
                             std::optional<WarpOptions> equal_to = std::nullopt) {
  return {.name = std::move(name),
          .family = KernelFamily::kPlain,
          .reads = std::move(reads),
          .prepare = [sampler](const ImageView& history, const MotionView& motion,
                               const MutableImageView& out) -> ResamplingKernel::Call {
            return [=] { PlainWarp(history, motion, sampler, out); };
          },
          .equal_to = equal_to};
}

// The weights as a table of `format` would hold them.
PlainTable Stored(const RealTable& table, TableFormat format) {
  std::vector<Weights<float>> rows;
  for (const IntegerRow& row : RoundTable(table, format)) {
    const Weights<double> real = RealRow(row, format);
    Weights<float> weights;
    std::copy(real.begin(), real.end(), weights.begin());
    rows.push_back(weights);
  }
  return {table.intervals, table.footprint, std::move(rows)};
}

// A sampler together with what it reads.
template <class Sampler, class Data>
auto Owning(std::shared_ptr<const Data> data, Sampler sampler) {
  return [data = std::move(data), sampler](const PlainHistory& history, int x, int y, float dx,
                                           float dy) mutable {
    return sampler(history, x, y, dx, dy);
  };
}

ResamplingKernel RemapKernel(std::string name, std::string reads, int interpolation) {
  return {
      .name = std::move(name),
      .family = KernelFamily::kOpenCv,
      .reads = std::move(reads),
      .prepare = [interpolation](const ImageView& history, const MotionView& motion,
                                 const MutableImageView& out) -> ResamplingKernel::Call {
        const int type = history.format == PixelFormat::kRgba8  ? CV_8UC4
                         : history.format == PixelFormat::kR32F ? CV_32FC1
                                                                : CV_32FC4;
        cv::Mat map(out.height, out.width, CV_32FC2);
        for (int y = 0; y < map.rows; ++y) {
          const float* m = motion.Row(y);
          for (int x = 0; x < map.cols; ++x, m += 2) {
            map.at<cv::Vec2f>(y, x) = {static_cast<float>(x) - m[0], static_cast<float>(y) - m[1]};
          }
        }
        // OpenCV takes its source as not const and does not write to it.
        const cv::Mat source(history.height, history.width, type, const_cast<void*>(history.data),
                             static_cast<std::size_t>(history.stride));
        const cv::Mat destination(out.height, out.width, type, out.data,
                                  static_cast<std::size_t>(out.stride));
        return [=] {
          cv::Mat result = destination;  // the same pixels
          cv::remap(source, result, map, cv::Mat(), interpolation, cv::BORDER_REPLICATE);
        };
      },
      .equal_to = std::nullopt};
}

std::string TexelsOf(Footprint footprint) { return fmt::format("{} texels", TapCount(footprint)); }

void AddRuntimeKernels(const ReportLut& lut, float keys_a, std::vector<ResamplingKernel>& kernels) {
  kernels.push_back(RuntimeKernel("bilinear", "4 texels", {.filter = Filter::kBilinear}));
  kernels.push_back(RuntimeKernel("catmull-rom", "16 texels", {.filter = Filter::kCatmullRom}));
  kernels.push_back(RuntimeKernel(fmt::format("keys:{:.2f}", keys_a), "16 texels",
                                  {.filter = Filter::kKeys, .keys_a = keys_a}));
  for (const TableFormat format : kTableFormats) {
    std::shared_ptr<const Table> table;
    if (lut.fit) {
      table = std::make_shared<const Table>(Quantize(SampleFit(*lut.fit, kNodes), format).view());
    } else if (format == lut.baked->format()) {
      table = std::make_shared<const Table>(lut.baked->view());
    } else {
      continue;
    }
    for (const Lookup lookup : kLookups) {
      kernels.push_back(
          RuntimeKernel(fmt::format("LUT {} {} {}", kNodes, Name(format), Name(lookup)),
                        TexelsOf(table->footprint()),
                        {.filter = Filter::kLut, .table = table.get(), .lookup = lookup}, table));
    }
  }
}

void AddPlainKernels(std::vector<ResamplingKernel>& kernels) {
  kernels.push_back(PlainKernel("nearest, plain", "1 texel", NearestSampler()));
  kernels.push_back(PlainKernel("bilinear, plain", "4 texels", BilinearSampler(),
                                WarpOptions{.filter = Filter::kBilinear}));
  const WarpOptions catmull_rom{.filter = Filter::kCatmullRom};
  kernels.push_back(
      PlainKernel("catmull-rom, plain", "16 texels", CatmullRomSampler(), catmull_rom));
  kernels.push_back(
      PlainKernel("catmull-rom 9", "9 fetches", FetchedCatmullRomSampler<true>(), catmull_rom));
  kernels.push_back(PlainKernel("catmull-rom 5", "5 fetches", FetchedCatmullRomSampler<false>()));
  kernels.push_back(PlainKernel("lanczos 3", "36 texels", LanczosSampler()));
}

void AddFittedKernels(const Fit& fit, std::vector<ResamplingKernel>& kernels) {
  constexpr TableFormat kFormat = TableFormat::kI16;
  const std::string texels = TexelsOf(fit.footprint);
  for (const int nodes : kComparedNodes) {
    const auto table = std::make_shared<const PlainTable>(Stored(SampleFit(fit, nodes), kFormat));
    const auto name = [&](Lookup lookup) {
      return fmt::format("LUT {} {} {}, plain", nodes, Name(kFormat), Name(lookup));
    };
    kernels.push_back(PlainKernel(name(Lookup::kNearest), texels,
                                  Owning(table, TableSampler<Lookup::kNearest>{table.get()})));
    kernels.push_back(PlainKernel(name(Lookup::kBilinear), texels,
                                  Owning(table, TableSampler<Lookup::kBilinear>{table.get()})));
  }
  const auto parameters =
      std::make_shared<const std::vector<float>>(fit.parameters.begin(), fit.parameters.end());
  kernels.push_back(
      PlainKernel("exact MLP", texels,
                  Owning(parameters, MlpSampler(parameters.get(), fit.footprint, fit.kaiser_b))));
  kernels.back().slow = true;
}

float RoundedTo(PixelFormat format, float value) {
  alignas(float) std::byte pixel[sizeof(float)];
  const float scale = ChannelScale(format);
  StoreChannel(format, scale * value, pixel, 0);
  return LoadChannel(format, pixel, 0) / scale;
}

}  // namespace

std::vector<ResamplingKernel> ResamplingKernels(const ReportLut& lut, float keys_a) {
  std::vector<ResamplingKernel> kernels;
  AddRuntimeKernels(lut, keys_a, kernels);
  AddPlainKernels(kernels);
  if (lut.fit) AddFittedKernels(*lut.fit, kernels);
  kernels.push_back(RemapKernel("remap linear", "4 texels", cv::INTER_LINEAR));
  kernels.push_back(RemapKernel("remap cubic", "16 texels", cv::INTER_CUBIC));
  kernels.push_back(RemapKernel("remap lanczos4", "64 texels", cv::INTER_LANCZOS4));
  return kernels;
}

ProtocolFilter AsProtocolFilter(const ResamplingKernel& kernel, PixelFormat format) {
  const ProtocolFilter exact = UniformFilter(
      kernel.name,
      [prepare = kernel.prepare](const ImageView& history, const MotionView& motion,
                                 const MutableImageView& out) { prepare(history, motion, out)(); });
  if (format == PixelFormat::kRgba32F) return exact;
  return {.name = kernel.name,
          .warp = [exact, format](const Image& in, const Displacement& v, Image& out) {
            exact.warp(in, v, out);
            for (float& value : out.data) value = RoundedTo(format, value);
          }};
}

}  // namespace warplut
