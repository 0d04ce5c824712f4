#include "runtime/gpu/gpu_super_resolution.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "runtime/gpu/frame_numbers.h"
#include "runtime/gpu/gpu_filter.h"
#include "runtime/gpu/gpu_motion_filter.h"
#include "runtime/gpu/image_transfer.h"
#include "runtime/motion_filter.h"
#include "runtime/sr/frame_check.h"
#include "runtime/sr/reference.h"

namespace warplut {

struct GpuSuperResolution::State {
  State(const GpuDevice& device, const SuperResolutionOptions& chosen,
        const InputConventions& stored, bool gives_geometry);

  // Whether what is shown differs from the history.
  bool ShowsDecoded() const { return EncodingOf(options) == ColorEncoding::kLinearHdr; }
  void AddResources();
  void AddPasses();
  void Prepare();
  std::vector<std::int32_t> Constants() const;
  FrameNumbers NumbersOf(const RenderedFrame& frame) const;
  void Upload(const RenderedFrame& frame);
  void Record();
  // A pass of the render grid.
  void RecordRendered(int pass) {
    gpu->RecordGrid(pass, &numbers, 0, options.render_width, options.render_height);
  }
  void Process(const RenderedFrame& frame, const MutableImageView& out);
  OutputGeometry Geometry();

  int AddPass(const char* name, Shader shader, const std::vector<int>& stored,
              const std::vector<int>& sampled, int width, int height, int group = 8);

  SuperResolutionOptions options;     // with the render size of the next frame
  const int most_width, most_height;  // of rendered frames
  InputConventions conventions;
  bool makes_geometry;
  Prefilter prefilter;
  std::unique_ptr<GpuWorkspace> gpu;
  PrefilterPasses prefilter_passes;
  MotionFilterPasses motion_passes;
  ImageBuffer geometry_depth;  // where there is geometry
  MotionBuffer geometry_motion;
  FrameNumbers numbers = {};  // of the last frame
  GpuInt2 render_size_before = {1, 1};
  float jitter_x_before = 0, jitter_y_before = 0;
  bool has_history = false, is_cut = true;

  // Images.
  int color, depth, motion, filtered, history, columns, coefficients, table, box_low, box_high,
      nearest, farthest, reactive, reach, predicted, residual, variances, smoothing, shown,
      output_depth, output_motion;
  // Buffers.
  int camera, color_bytes, depth_bytes, motion_bytes, reactive_bytes, table_bytes, shown_bytes,
      output_depth_bytes, output_motion_bytes;
  // Passes; -1 where the options do without.
  int samples = -1, predict = -1, difference = -1, smooth = -1, update = -1, depth_range = -1,
      reactive_reach = -1, geometry = -1;
};

GpuSuperResolution::State::State(const GpuDevice& device, const SuperResolutionOptions& chosen,
                                 const InputConventions& stored, bool gives_geometry)
    : options(chosen),
      most_width(chosen.render_width),
      most_height(chosen.render_height),
      conventions(stored),
      makes_geometry(gives_geometry),
      prefilter(PrefiltersHistory(chosen) ? PrefilterOf(chosen.warp) : Prefilter{}),
      gpu(device.MakeWorkspace(HistoryFormatOf(chosen))) {
  AddResources();
  AddPasses();
  Prepare();
}

// Images that the options do without are one texel: shaders name them, and do not read them.
void GpuSuperResolution::State::AddResources() {
  const int rw = options.render_width, rh = options.render_height;
  const int ow = options.output_width, oh = options.output_height;
  const TexelFormat format = TexelFormatOf(HistoryFormatOf(options));
  const auto image = [&](bool is_needed, TexelFormat texels, int width, int height) {
    return gpu->AddImage({texels, is_needed ? width : 1, is_needed ? height : 1});
  };
  const bool gates = DepthOf(options) != DepthMeasure::kNone;
  const int tiles_x = TileCount(rw, kAliasingTile), tiles_y = TileCount(rh, kAliasingTile);
  color = image(true, conventions.color_format, rw, rh);
  depth = image(ReadsMotion(options), TexelFormat::kR32F, rw, rh);
  motion = image(ReadsMotion(options), conventions.motion_format, rw, rh);
  filtered = image(FiltersMotion(options), kFilteredMotionFormat, rw, rh);
  history = image(true, format, ow, oh);
  columns = image(HasPrefilter(prefilter), format, ow, oh);
  coefficients = image(HasPrefilter(prefilter), format, ow, oh);
  box_low = image(true, format, rw, rh);
  box_high = image(true, format, rw, rh);
  nearest = image(gates, TexelFormat::kR32F, rw, rh);
  farthest = image(gates, TexelFormat::kR32F, rw, rh);
  reactive = image(ReadsReactive(options), conventions.reactive_format, rw, rh);
  reach = image(ReadsReactive(options), TexelFormat::kR32F, rw, rh);
  predicted = image(true, format, ow, oh);
  residual = image(HasResidual(options), format, rw, rh);
  variances = image(HasResidual(options), TexelFormat::kR32F, tiles_x, tiles_y);
  smoothing = image(SmoothsAliasing(options), TexelFormat::kR32F, tiles_x, tiles_y);
  shown = image(ShowsDecoded(), format, ow, oh);
  output_depth = image(makes_geometry, TexelFormat::kR32F, ow, oh);
  output_motion = image(makes_geometry, TexelFormat::kRgba32F, ow, oh);
  table = AddTableImage(options.warp, *gpu);

  camera = AddCameraBuffer(*gpu);
  color_bytes = gpu->AddBufferOf(color);
  depth_bytes = gpu->AddBufferOf(depth);
  motion_bytes = gpu->AddBufferOf(motion);
  reactive_bytes = gpu->AddBufferOf(reactive);
  table_bytes = gpu->AddBufferOf(table);
  shown_bytes = gpu->AddBufferOf(history);
  output_depth_bytes = gpu->AddBufferOf(output_depth);
  output_motion_bytes = gpu->AddBufferOf(output_motion);
  gpu->Allocate();
  const std::vector<float> texels = TableTexels(options.warp);
  std::memcpy(gpu->BytesOf(table_bytes), texels.data(), texels.size() * sizeof(float));
}

// constant_id 0, 1, ... of shaders/super_resolution.glsl.
std::vector<std::int32_t> GpuSuperResolution::State::Constants() const {
  const auto number = [](auto value) { return static_cast<std::int32_t>(value); };
  std::vector<std::int32_t> constants = {number(FormOf(options)),      number(ClampOf(options)),
                                         number(DepthOf(options)),     number(MotionOf(options)),
                                         number(CurrentOf(options)),   number(EncodingOf(options)),
                                         number(KeepsHistory(options))};
  AppendFilterConstants(options.warp, HasPrefilter(prefilter), &constants);
  constants.push_back(number(conventions.depth_buffer));
  constants.push_back(number(ReadsReactive(options)));
  return constants;
}

int GpuSuperResolution::State::AddPass(const char* name, Shader shader,
                                       const std::vector<int>& stored,
                                       const std::vector<int>& sampled, int width, int height,
                                       int group) {
  std::vector<Binding> bindings;
  for (const int i : stored) bindings.push_back(Stored(i));
  for (const int i : sampled) bindings.push_back(Sampled(i));
  return gpu->AddPass({.name = name,
                       .shader = shader,
                       .constants = Constants(),
                       .sets = {bindings},
                       .numbers_bytes = sizeof(FrameNumbers),
                       .width = width,
                       .height = height,
                       .group_width = group,
                       .group_height = group});
}

void GpuSuperResolution::State::AddPasses() {
  const int rw = options.render_width, rh = options.render_height;
  const int ow = options.output_width, oh = options.output_height;
  prefilter_passes = PrefilterPasses(prefilter, ow, oh, {{history, columns, coefficients}}, *gpu);
  if (FiltersMotion(options)) {
    motion_passes = MotionFilterPasses(MotionFilterOptions{}.limit, conventions, camera,
                                       {{depth, motion, filtered}}, *gpu);
  }
  const int moved = FiltersMotion(options) ? filtered : motion;
  samples = AddPass("samples", Shader::kSamples, {box_low, box_high}, {color}, rw, rh);
  predict = AddPass("predict", Shader::kPredict, {predicted},
                    {color, depth, moved, history, coefficients, table, box_low, box_high, nearest,
                     farthest, reactive, reach},
                    ow, oh);
  if (HasResidual(options)) {
    difference = AddPass("residual", Shader::kResidual, {residual, variances}, {color, predicted},
                         rw, rh, kAliasingTile);
  }
  if (SmoothsAliasing(options)) {
    const ImagePlan& tiles = gpu->image(smoothing);
    smooth =
        AddPass("aliasing", Shader::kAliasing, {smoothing}, {variances}, tiles.width, tiles.height);
  }
  update = AddPass("update", Shader::kUpdate, {history, shown},
                   {color, predicted, residual, smoothing}, ow, oh);
  if (DepthOf(options) != DepthMeasure::kNone) {
    depth_range = AddPass("depth range", Shader::kDepthRange, {nearest, farthest}, {depth}, rw, rh);
  }
  if (ReadsReactive(options)) {
    reactive_reach = AddPass("reactive reach", Shader::kReactiveReach, {reach}, {reactive}, rw, rh);
  }
  if (makes_geometry) {
    geometry = AddPass("geometry", Shader::kGeometry, {output_depth, output_motion}, {depth, moved},
                       ow, oh);
    geometry_depth = ImageBuffer(ow, oh, PixelFormat::kR32F);
    geometry_motion = MotionBuffer(ow, oh);
  }
}

void GpuSuperResolution::State::Prepare() {
  gpu->Run([&] { gpu->CopyToImage(table_bytes, table); });
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
      .render_size_before = render_size_before,
      .jitter = {frame.jitter_x, frame.jitter_y},
      .jitter_before = {jitter_x_before, jitter_y_before},
      .motion_scale = FiltersMotion(options) ? GpuFloat2{1, 1} : MotionScaleOf(conventions),
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
      .filter_parameter = FilterParameterOf(options.warp),
      .most_smoothing = MostSmoothing(area),
      .variance_unit = CodeContrast(encoding) * CodeContrast(encoding),
      .has_history = has_history && !frame.cut ? 1 : 0,
      .padding = {}};
}

void GpuSuperResolution::State::Upload(const RenderedFrame& frame) {
  PackColor(frame.color, conventions.color_format, gpu->BytesOf(color_bytes));
  if (ReadsReactive(options)) {
    std::byte* texels = gpu->BytesOf(reactive_bytes);
    if (frame.reactive.data != nullptr) {
      PackReactive(frame.reactive, conventions.reactive_format, texels);
    } else {
      std::memset(texels, 0, gpu->buffer(reactive_bytes).size);
    }
  }
  if (!ReadsMotion(options)) return;
  PackDepth(frame.depth, gpu->BytesOf(depth_bytes));
  PackMotion(frame.motion, conventions.motion_format, gpu->BytesOf(motion_bytes));
}

// The order of the passes.
void GpuSuperResolution::State::Record() {
  const int rw = options.render_width, rh = options.render_height;
  gpu->CopyToCorner(color_bytes, color, rw, rh);
  if (ReadsMotion(options)) {
    gpu->CopyToCorner(depth_bytes, depth, rw, rh);
    gpu->CopyToCorner(motion_bytes, motion, rw, rh);
  }
  if (ReadsReactive(options)) gpu->CopyToCorner(reactive_bytes, reactive, rw, rh);
  if (numbers.has_history != 0) prefilter_passes.Record(0, *gpu);
  motion_passes.Record(0, rw, rh, *gpu);
  RecordRendered(samples);
  gpu->Record(predict, &numbers);
  RecordRendered(difference);
  gpu->RecordGrid(smooth, &numbers, 0, TileCount(rw, kAliasingTile), TileCount(rh, kAliasingTile));
  gpu->Record(update, &numbers);
  RecordRendered(depth_range);
  RecordRendered(reactive_reach);
  gpu->CopyToBuffer(ShowsDecoded() ? shown : history, shown_bytes);
}

void GpuSuperResolution::State::Process(const RenderedFrame& frame, const MutableImageView& out) {
  Upload(frame);
  numbers = NumbersOf(frame);
  gpu->Run([&] { Record(); });
  UnpackColor(gpu->BytesOf(shown_bytes), HistoryFormatOf(options), out);
  render_size_before = numbers.render_size;
  jitter_x_before = frame.jitter_x;
  jitter_y_before = frame.jitter_y;
  is_cut = frame.cut || !has_history;
  has_history = true;
}

OutputGeometry GpuSuperResolution::State::Geometry() {
  gpu->Run([&] {
    gpu->Record(geometry, &numbers);
    gpu->CopyToBuffer(output_depth, output_depth_bytes);
    gpu->CopyToBuffer(output_motion, output_motion_bytes);
  });
  UnpackDepth(gpu->BytesOf(output_depth_bytes), geometry_depth.view());
  UnpackMotion(gpu->BytesOf(output_motion_bytes), geometry_motion.view());
  return {.depth = std::as_const(geometry_depth).view(),
          .motion = std::as_const(geometry_motion).view(),
          .cut = is_cut};
}

GpuSuperResolution::GpuSuperResolution(const GpuDevice& device,
                                       const SuperResolutionOptions& options,
                                       const InputConventions& conventions, bool makes_geometry)
    : state_(std::make_unique<State>(device, options, conventions, makes_geometry)) {}

GpuSuperResolution::~GpuSuperResolution() = default;

void GpuSuperResolution::Process(const RenderedFrame& frame, const MutableImageView& out) {
  state_->Process(frame, out);
}

void GpuSuperResolution::SetRenderSize(int width, int height) {
  state_->options.render_width = width;
  state_->options.render_height = height;
}

bool GpuSuperResolution::IsRenderSize(int width, int height, std::string* why) const {
  return IsRenderSizeOf(state_->options, width, height, state_->most_width, state_->most_height,
                        why);
}

void GpuSuperResolution::Reset() { state_->has_history = false; }

OutputGeometry GpuSuperResolution::Geometry() { return state_->Geometry(); }

std::vector<PassTime> GpuSuperResolution::Times() const { return state_->gpu->Times(); }

std::size_t GpuSuperResolution::MemoryBytes() const { return state_->gpu->bytes(); }

}  // namespace warplut
