#include "runtime/gpu/gpu_warp.h"

#include <cstring>

#include "runtime/gpu/frame_numbers.h"
#include "runtime/gpu/gpu_filter.h"
#include "runtime/gpu/image_transfer.h"

namespace warplut {

struct GpuWarp::State {
  State(const GpuDevice& device, const GpuWarpOptions& chosen);

  void AddPasses();
  void Apply(const ImageView& image, const MotionView& motion, const MutableImageView& out);

  GpuWarpOptions options;
  std::unique_ptr<GpuWorkspace> gpu;
  PrefilterPasses filter_passes;
  int samples, columns, coefficients, motion_image, table, warped;  // images
  int sample_bytes, motion_bytes, warped_bytes;                     // buffers
  int warp = -1;                                                    // pass
};

GpuWarp::State::State(const GpuDevice& device, const GpuWarpOptions& chosen)
    : options(chosen), gpu(device.MakeWorkspace(chosen.format)) {
  const int width = options.width, height = options.height;
  const bool filters = HasPrefilter(PrefilterOf(options.warp));
  const auto image = [&](bool is_needed, TexelFormat format) {
    return gpu->AddImage({format, is_needed ? width : 1, is_needed ? height : 1});
  };
  const TexelFormat texels = TexelFormatOf(options.format);
  samples = image(true, texels);
  columns = image(filters, texels);
  coefficients = image(filters, texels);
  motion_image = image(true, TexelFormat::kRg32F);
  warped = image(true, texels);
  table = AddTableImage(options.warp, *gpu);
  sample_bytes = gpu->AddBufferOf(samples);
  motion_bytes = gpu->AddBufferOf(motion_image);
  warped_bytes = gpu->AddBufferOf(warped);
  const int table_bytes = gpu->AddBufferOf(table);
  gpu->Allocate();
  const std::vector<float> nodes = TableTexels(options.warp);
  std::memcpy(gpu->BytesOf(table_bytes), nodes.data(), nodes.size() * sizeof(float));
  AddPasses();
  gpu->Run([&] { gpu->CopyToImage(table_bytes, table); });
}

void GpuWarp::State::AddPasses() {
  const Prefilter prefilter = PrefilterOf(options.warp);
  filter_passes = PrefilterPasses(prefilter, options.width, options.height,
                                  {{samples, columns, coefficients}}, *gpu);
  // constant_id 0, 1, ... of shaders/formulas.glsl and shaders/warp.comp; 0 to 6 are of others.
  PassPlan plan = {
      .name = "warp",
      .shader = Shader::kWarp,
      .constants = std::vector<std::int32_t>(7, 0),
      .sets = {{Stored(warped), options.fetches < 16 ? Filtered(samples) : Sampled(samples),
                Sampled(coefficients), Sampled(table), Sampled(motion_image)}},
      .numbers_bytes = sizeof(WarpNumbers),
      .width = options.width,
      .height = options.height};
  AppendFilterConstants(options.warp, HasPrefilter(prefilter), &plan.constants);
  plan.constants.push_back(0);
  plan.constants.push_back(options.fetches);
  warp = gpu->AddPass(plan);
}

void GpuWarp::State::Apply(const ImageView& image, const MotionView& motion,
                           const MutableImageView& out) {
  PackColor(image, gpu->image(samples).format, gpu->BytesOf(sample_bytes));
  PackMotion(motion, gpu->image(motion_image).format, gpu->BytesOf(motion_bytes));
  const WarpNumbers numbers = {.output_size = {options.width, options.height},
                               .filter_parameter = FilterParameterOf(options.warp),
                               .padding = 0};
  gpu->Run([&] {
    gpu->CopyToImage(sample_bytes, samples);
    gpu->CopyToImage(motion_bytes, motion_image);
    filter_passes.Record(0, *gpu);
    gpu->Record(warp, &numbers);
    gpu->CopyToBuffer(warped, warped_bytes);
  });
  UnpackColor(gpu->BytesOf(warped_bytes), options.format, out);
}

bool GpuWarpOptions::IsValid(std::string* why) const {
  constexpr int kLargest = 1 << 14;
  std::string reason;
  const char* wrong = nullptr;
  if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
    reason = "the image is " + std::to_string(width) + " x " + std::to_string(height) +
             "; expected sides of 1 to " + std::to_string(kLargest);
  } else if (format != PixelFormat::kRgba16F && format != PixelFormat::kRgba32F) {
    reason = std::string("the format is ") + warplut::Name(format) +
             "; the GPU takes rgba16f or rgba32f";
  } else if (!warp.IsValid(&wrong)) {
    reason = wrong;
  } else if (fetches != 16 && fetches != 9 && fetches != 5) {
    reason = "the warp has " + std::to_string(fetches) + " fetches; expected 16, 9 or 5";
  } else if (fetches != 16 &&
             (warp.filter != Filter::kCatmullRom || format != PixelFormat::kRgba16F)) {
    reason =
        "a warp in " + std::to_string(fetches) +
        " fetches is that of Catmull-Rom in rgba16f; the options have another filter or format";
  }
  if (why != nullptr) *why = reason;
  return reason.empty();
}

GpuWarp::GpuWarp(const GpuDevice& device, const GpuWarpOptions& options)
    : state_(std::make_unique<State>(device, options)) {}

GpuWarp::~GpuWarp() = default;

void GpuWarp::Apply(const ImageView& image, const MotionView& motion, const MutableImageView& out) {
  state_->Apply(image, motion, out);
}

std::vector<PassTime> GpuWarp::Times() const { return state_->gpu->Times(); }

}  // namespace warplut
