#include "runtime/gpu/gpu_super_resolution.h"

#include <algorithm>
#include <cstring>

#include "runtime/core/pixel.h"
#include "runtime/gpu/frame_numbers.h"
#include "runtime/gpu/gpu_commands.h"
#include "runtime/gpu/shader_code.h"
#include "runtime/motion_filter.h"
#include "runtime/prefilter.h"
#include "runtime/sr/reference.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

constexpr int kPrefilterLength = 64, kPrefilterLines = 8;  // of shaders/prefilter.comp

// Texels of the table's texture, in floats (luts/bake/table_texture.h).
std::vector<float> TableTexels(const Table& table) {
  const int layers = LayoutOf(table.footprint()).count;
  constexpr int kTexels = kTableNodes * kTableNodes;
  std::vector<float> texels;
  for (int layer = 0; layer < layers; ++layer) {
    for (int texel = 0; texel < kTexels; ++texel) {
      const float* row = table.data() + texel * RowFloats(table.footprint()) + layer * kGroupTaps;
      texels.insert(texels.end(), row, row + kGroupTaps);
    }
  }
  return texels;
}

}  // namespace

struct GpuSuperResolution::State {
  State(const VulkanDevice& vulkan, const SuperResolutionOptions& chosen,
        const InputConventions& stored);
  ~State() { vkDestroySampler(device.handle(), sampler, nullptr); }

  // Whether what is shown differs from the history.
  bool ShowsDecoded() const { return EncodingOf(options) == ColorEncoding::kLinearHdr; }
  void AddResources();
  void AddPasses();
  void Prepare();
  std::vector<std::int32_t> Constants() const;
  FrameNumbers NumbersOf(const RenderedFrame& frame) const;
  PrefilterNumbers PrefilterOfAxis(bool along_x) const;
  MotionView Filtered(const RenderedFrame& frame);
  void Upload(const RenderedFrame& frame);
  void Record(VkCommandBuffer commands, const RenderedFrame& frame);
  void Download(const MutableImageView& out) const;
  void Process(const RenderedFrame& frame, const MutableImageView& out);

  int AddPass(const char* name, Shader shader, const std::vector<int>& sampled,
              const std::vector<int>& stored, int width, int height, int group = 8);

  const VulkanDevice& device;
  SuperResolutionOptions options;
  InputConventions conventions;
  Prefilter prefilter;
  GpuResources resources;
  GpuCommands commands;
  VkSampler sampler = VK_NULL_HANDLE;
  std::vector<std::unique_ptr<ComputePass>> passes;
  SerialExecutor executor;  // of the motion filter
  std::unique_ptr<MotionFilter> filter;
  MotionBuffer filtered;
  std::vector<const char*> run;  // names of the passes of the last frame
  float jitter_x_before = 0, jitter_y_before = 0;
  bool has_history = false;

  // Images.
  int color, depth, motion, history, columns, coefficients, table, box_low, box_high, nearest,
      farthest, predicted, residual, variances, smoothing, shown;
  // Buffers.
  int color_bytes, depth_bytes, motion_bytes, table_bytes, shown_bytes;
  // Passes; -1 where the options do without.
  int filter_columns = -1, filter_rows = -1, samples = -1, predict = -1, difference = -1,
      smooth = -1, update = -1, depth_range = -1;
};

GpuSuperResolution::State::State(const VulkanDevice& vulkan, const SuperResolutionOptions& chosen,
                                 const InputConventions& stored)
    : device(vulkan),
      options(chosen),
      conventions(stored),
      prefilter(PrefiltersHistory(chosen) ? PrefilterOf(chosen.warp) : Prefilter{}),
      resources(vulkan),
      commands(vulkan, 16) {
  const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                    .pNext = nullptr,
                                    .flags = 0,
                                    .magFilter = VK_FILTER_NEAREST,
                                    .minFilter = VK_FILTER_NEAREST,
                                    .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                    .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                    .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                    .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                    .mipLodBias = 0,
                                    .anisotropyEnable = VK_FALSE,
                                    .maxAnisotropy = 1,
                                    .compareEnable = VK_FALSE,
                                    .compareOp = VK_COMPARE_OP_NEVER,
                                    .minLod = 0,
                                    .maxLod = 0,
                                    .borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_BLACK,
                                    .unnormalizedCoordinates = VK_FALSE};
  CheckVulkan(vkCreateSampler(device.handle(), &info, nullptr, &sampler), "to make a sampler");
  try {
    AddResources();
    AddPasses();
    Prepare();
  } catch (...) {
    vkDestroySampler(device.handle(), sampler, nullptr);
    throw;
  }
}

// Images that the options do without are one texel: shaders name them, and do not read them.
void GpuSuperResolution::State::AddResources() {
  const int rw = options.render_width, rh = options.render_height;
  const int ow = options.output_width, oh = options.output_height;
  const VkFormat format = VulkanFormat(HistoryFormatOf(options));
  const auto image = [&](bool is_needed, VkFormat texels, int width, int height) {
    return resources.AddImage(texels, is_needed ? width : 1, is_needed ? height : 1);
  };
  const bool gates = DepthOf(options) != DepthMeasure::kNone;
  const int tiles_x = TileCount(rw, kAliasingTile), tiles_y = TileCount(rh, kAliasingTile);
  color = image(true, VK_FORMAT_R32G32B32A32_SFLOAT, rw, rh);
  depth = image(ReadsMotion(options), VK_FORMAT_R32_SFLOAT, rw, rh);
  motion = image(ReadsMotion(options), VK_FORMAT_R32G32_SFLOAT, rw, rh);
  history = image(true, format, ow, oh);
  columns = image(HasPrefilter(prefilter), format, ow, oh);
  coefficients = image(HasPrefilter(prefilter), format, ow, oh);
  box_low = image(true, format, rw, rh);
  box_high = image(true, format, rw, rh);
  nearest = image(gates, VK_FORMAT_R32_SFLOAT, rw, rh);
  farthest = image(gates, VK_FORMAT_R32_SFLOAT, rw, rh);
  predicted = image(true, format, ow, oh);
  residual = image(HasResidual(options), format, rw, rh);
  variances = image(HasResidual(options), VK_FORMAT_R32_SFLOAT, tiles_x, tiles_y);
  smoothing = image(SmoothsAliasing(options), VK_FORMAT_R32_SFLOAT, tiles_x, tiles_y);
  shown = image(ShowsDecoded(), format, ow, oh);
  const bool has_table = WarpsHistory(options) && FilterOf(options.warp) == Filter::kLut;
  const int layers = has_table ? LayoutOf(options.warp.table->footprint()).count : 1;
  table = resources.AddImage(VK_FORMAT_R32G32B32A32_SFLOAT, kTableNodes, kTableNodes, layers);

  const auto bytes = [&](int i) {
    const GpuImage& of = resources.image(i);
    return TexelBytes(of.format) * static_cast<std::size_t>(of.width) *
           static_cast<std::size_t>(of.height) * static_cast<std::size_t>(std::max(of.layers, 1));
  };
  color_bytes = resources.AddBuffer(bytes(color));
  depth_bytes = resources.AddBuffer(bytes(depth));
  motion_bytes = resources.AddBuffer(bytes(motion));
  table_bytes = resources.AddBuffer(bytes(table));
  shown_bytes = resources.AddBuffer(bytes(history));
  resources.Allocate();
  if (!has_table) return;
  const std::vector<float> texels = TableTexels(*options.warp.table);
  std::memcpy(resources.buffer(table_bytes).bytes, texels.data(), texels.size() * sizeof(float));
}

// constant_id 0, 1, ... of shaders/common.glsl.
std::vector<std::int32_t> GpuSuperResolution::State::Constants() const {
  const auto number = [](auto value) { return static_cast<std::int32_t>(value); };
  return {number(FormOf(options)),
          number(ClampOf(options)),
          number(DepthOf(options)),
          number(MotionOf(options)),
          number(CurrentOf(options)),
          number(EncodingOf(options)),
          number(KeepsHistory(options)),
          number(FilterOf(options.warp)),
          number(LookupOf(options.warp)),
          number(HasPrefilter(prefilter)),
          number(resources.image(table).layers),
          number(conventions.depth_buffer)};
}

int GpuSuperResolution::State::AddPass(const char* name, Shader shader,
                                       const std::vector<int>& sampled,
                                       const std::vector<int>& stored, int width, int height,
                                       int group) {
  PassOptions pass = {.name = name,
                      .spirv = CodeOf(shader, HistoryFormatOf(options)),
                      .constants = Constants(),
                      .images = {},
                      .numbers_bytes = sizeof(FrameNumbers),
                      .width = width,
                      .height = height,
                      .group_width = group,
                      .group_height = group};
  for (const int i : sampled) pass.images.push_back({resources.image(i).view, false});
  for (const int i : stored) pass.images.push_back({resources.image(i).view, true});
  if (shader == Shader::kPrefilter) {
    pass.constants = {prefilter.kind == PrefilterKind::kRecursive ? 1 : 0};
    pass.numbers_bytes = sizeof(PrefilterNumbers);
    pass.group_width = kPrefilterLength;
    pass.group_height = kPrefilterLines;
  }
  passes.push_back(std::make_unique<ComputePass>(device, pass, sampler));
  return static_cast<int>(passes.size()) - 1;
}

void GpuSuperResolution::State::AddPasses() {
  const int rw = options.render_width, rh = options.render_height;
  const int ow = options.output_width, oh = options.output_height;
  if (HasPrefilter(prefilter)) {
    filter_columns = AddPass("prefilter columns", Shader::kPrefilter, {history}, {columns}, oh, ow);
    filter_rows = AddPass("prefilter rows", Shader::kPrefilter, {columns}, {coefficients}, ow, oh);
  }
  samples = AddPass("samples", Shader::kSamples, {color}, {box_low, box_high}, rw, rh);
  predict = AddPass(
      "predict", Shader::kPredict,
      {color, depth, motion, history, coefficients, table, box_low, box_high, nearest, farthest},
      {predicted}, ow, oh);
  if (HasResidual(options)) {
    difference = AddPass("residual", Shader::kResidual, {color, predicted}, {residual, variances},
                         rw, rh, kAliasingTile);
  }
  if (SmoothsAliasing(options)) {
    const GpuImage& tiles = resources.image(smoothing);
    smooth =
        AddPass("aliasing", Shader::kAliasing, {variances}, {smoothing}, tiles.width, tiles.height);
  }
  update = AddPass("update", Shader::kUpdate, {color, predicted, residual, smoothing},
                   {history, shown}, ow, oh);
  if (DepthOf(options) != DepthMeasure::kNone) {
    depth_range = AddPass("depth range", Shader::kDepthRange, {depth}, {nearest, farthest}, rw, rh);
  }
}

void GpuSuperResolution::State::Prepare() {
  commands.Run([&](VkCommandBuffer recorded) {
    for (const GpuImage& image : resources.images()) PrepareImage(recorded, image);
    CopyToImage(recorded, resources.buffer(table_bytes), resources.image(table));
  });
}

FrameNumbers GpuSuperResolution::State::NumbersOf(const RenderedFrame& frame) const {
  const PixelFormat format = HistoryFormatOf(options);
  const ColorEncoding encoding = EncodingOf(options);
  const Parameters& p = options.parameters;
  const bool residuals = HasResidual(options);
  const float slack = ResidualSlack(format);
  const float area = AxisMap(options.render_width, options.output_width).scale() *
                     AxisMap(options.render_height, options.output_height).scale();
  return {
      .render_size = {options.render_width, options.render_height},
      .output_size = {options.output_width, options.output_height},
      .jitter = {frame.jitter_x, frame.jitter_y},
      .jitter_before = {jitter_x_before, jitter_y_before},
      .motion_scale = {conventions.motion_scale_x, conventions.motion_scale_y},
      .depth_a = conventions.depth_a,
      .depth_b = conventions.depth_b,
      .depth_threshold = p.sr_depth_threshold,
      .blend_a = p.blend_a,
      .blend_b = p.blend_b,
      .clamp_gamma = p.clamp_gamma,
      .gate_width = options.gate_width,
      .settled_distance = SettledDistance(format, encoding) - (residuals ? slack : 0.0f),
      .least_step = residuals ? LeastResidualStep(format, encoding, p.blend_a) : LeastStep(format),
      .residual_slack = slack,
      .filter_parameter = FilterOf(options.warp) == Filter::kCatmullRom
                              ? static_cast<float>(kCatmullRomA)
                              : ParameterOf(options.warp),
      .most_smoothing = MostSmoothing(area),
      .variance_unit = CodeContrast(encoding) * CodeContrast(encoding),
      .has_history = has_history && !frame.cut ? 1 : 0};
}

PrefilterNumbers GpuSuperResolution::State::PrefilterOfAxis(bool along_x) const {
  const bool recursive = prefilter.kind == PrefilterKind::kRecursive;
  return {.size = {options.output_width, options.output_height},
          .along_x = along_x ? 1 : 0,
          .reach = PrefilterReach(prefilter),
          .pole = recursive ? static_cast<float>(PoleOfSide(static_cast<double>(prefilter.side)))
                            : 0.0f,
          .padding = {},
          .taps = prefilter.taps};
}

MotionView GpuSuperResolution::State::Filtered(const RenderedFrame& frame) {
  if (!FiltersMotion(options)) return frame.motion;
  if (filter == nullptr) {
    filter = std::make_unique<MotionFilter>(options.render_width, options.render_height,
                                            MotionFilterOptions{});
    filtered = MotionBuffer(options.render_width, options.render_height);
  }
  filter->Apply(frame.depth, frame.motion, executor, filtered.view());
  return static_cast<const MotionBuffer&>(filtered).view();
}

void GpuSuperResolution::State::Upload(const RenderedFrame& frame) {
  auto* to = reinterpret_cast<float*>(resources.buffer(color_bytes).bytes);
  const float unit = ChannelScale(frame.color.format);
  for (int y = 0; y < options.render_height; ++y) {
    for (int x = 0; x < options.render_width; ++x) {
      for (int c = 0; c < 4; ++c)
        *to++ = LoadChannel(frame.color.format, frame.color.At(x, y), c) / unit;
    }
  }
  if (!ReadsMotion(options)) return;
  const MotionView vectors = Filtered(frame);
  const std::size_t row = static_cast<std::size_t>(options.render_width) * sizeof(float);
  for (int y = 0; y < options.render_height; ++y) {
    const auto at = static_cast<std::size_t>(y) * row;
    std::memcpy(resources.buffer(depth_bytes).bytes + at, frame.depth.Row<float>(y), row);
    std::memcpy(resources.buffer(motion_bytes).bytes + 2 * at, vectors.Row(y), 2 * row);
  }
}

// The order of the passes.
void GpuSuperResolution::State::Record(VkCommandBuffer recorded, const RenderedFrame& frame) {
  CopyToImage(recorded, resources.buffer(color_bytes), resources.image(color));
  if (ReadsMotion(options)) {
    CopyToImage(recorded, resources.buffer(depth_bytes), resources.image(depth));
    CopyToImage(recorded, resources.buffer(motion_bytes), resources.image(motion));
  }
  const FrameNumbers numbers = NumbersOf(frame);
  run.clear();
  commands.Timestamp(recorded);
  const auto record = [&](int pass, const void* push) {
    if (pass < 0) return;
    passes[static_cast<std::size_t>(pass)]->Record(recorded, push);
    commands.Timestamp(recorded);
    run.push_back(passes[static_cast<std::size_t>(pass)]->name());
  };
  if (numbers.has_history != 0) {
    const PrefilterNumbers along_y = PrefilterOfAxis(false), along_x = PrefilterOfAxis(true);
    record(filter_columns, &along_y);
    record(filter_rows, &along_x);
  }
  for (const int pass : {samples, predict, difference, smooth, update, depth_range})
    record(pass, &numbers);
  CopyToBuffer(recorded, resources.image(ShowsDecoded() ? shown : history),
               resources.buffer(shown_bytes));
}

void GpuSuperResolution::State::Download(const MutableImageView& out) const {
  const PixelFormat format = HistoryFormatOf(options);
  const std::byte* from = resources.buffer(shown_bytes).bytes;
  const float scale = ChannelScale(out.format);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x, from += BytesPerPixel(format)) {
      for (int c = 0; c < 4; ++c)
        StoreChannel(out.format, LoadChannel(format, from, c) * scale, out.At(x, y), c);
    }
  }
}

void GpuSuperResolution::State::Process(const RenderedFrame& frame, const MutableImageView& out) {
  Upload(frame);
  commands.Run([&](VkCommandBuffer recorded) { Record(recorded, frame); });
  Download(out);
  jitter_x_before = frame.jitter_x;
  jitter_y_before = frame.jitter_y;
  has_history = KeepsHistory(options);
}

GpuSuperResolution::GpuSuperResolution(const VulkanDevice& device,
                                       const SuperResolutionOptions& options,
                                       const InputConventions& conventions)
    : state_(std::make_unique<State>(device, options, conventions)) {}

GpuSuperResolution::~GpuSuperResolution() = default;

void GpuSuperResolution::Process(const RenderedFrame& frame, const MutableImageView& out) {
  state_->Process(frame, out);
}

void GpuSuperResolution::Reset() { state_->has_history = false; }

std::vector<PassTime> GpuSuperResolution::Times() const {
  const std::vector<double> intervals = state_->commands.Intervals();
  std::vector<PassTime> times;
  for (std::size_t i = 0; i < intervals.size(); ++i)
    times.push_back({state_->run[i], intervals[i]});
  return times;
}

std::size_t GpuSuperResolution::MemoryBytes() const { return state_->resources.bytes(); }

}  // namespace warplut
