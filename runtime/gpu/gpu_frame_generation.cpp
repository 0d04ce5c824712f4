#include "runtime/gpu/gpu_frame_generation.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "runtime/configuration/chosen.h"
#include "runtime/generation/blend.h"
#include "runtime/generation/generation_job.h"
#include "runtime/gpu/frame_numbers.h"
#include "runtime/gpu/gpu_filter.h"
#include "runtime/gpu/gpu_motion_filter.h"
#include "runtime/gpu/image_transfer.h"
#include "runtime/hud.h"

namespace warplut {
namespace {

constexpr std::uint32_t kNoArrivalWord = generation::SplatSource(generation::kNoSplat);
constexpr std::size_t kSlots = 2;

// What is on the device of one of the two frames, in indices of GpuResources.
struct Slot {
  int color, depth, motion, filtered, codes, coefficients;  // images
  int color_bytes, depth_bytes, motion_bytes;               // buffers
  std::uint64_t id = 0;  // of the frame; 0: of none that can be found
  bool has_color = false;
};

// The passes of interpolation or of extrapolation.
struct KindOfFrame {
  int splat_depth = -1, splat_source = -1, generate = -1;
};

}  // namespace

std::size_t SplatKeyBytes(const FrameGenerationOptions& options) {
  const std::size_t pixels = Splats(options) ? static_cast<std::size_t>(options.width) *
                                                   static_cast<std::size_t>(options.height)
                                             : 1;
  return pixels * sizeof(generation::SplatKey);
}

struct GpuFrameGeneration::State {
  State(const GpuDevice& device, const FrameGenerationOptions& chosen, PixelFormat texels,
        const InputConventions& stored);

  bool Encodes() const { return EncodingOf(options) == ColorEncoding::kLinearHdr; }
  // What is warped of a frame.
  int Samples(const Slot& slot) const { return Encodes() ? slot.codes : slot.color; }
  void AddResources();
  void AddSharedPasses();
  const KindOfFrame& PassesOf(bool interpolates);
  std::vector<std::int32_t> Constants(bool interpolates, bool keeps_depth) const;
  // One list for each order of the slots: frames 0 and 1, or 1 and 0. Splatting takes the first
  // bindings of those that generating takes.
  std::vector<std::vector<Binding>> Sets(bool generates) const;
  std::size_t Find(const DisplayedFrame& frame, bool needs_color) const;
  void Upload(const DisplayedFrame& frame, Slot& slot);
  void RecordFrame(std::size_t slot);
  GenerationNumbers NumbersOf(const DisplayedFrame& frame0, float alpha) const;
  void Show(const ImageView& color, const MutableImageView& out) const;
  // By the processor.
  void Draw(const ImageView& hud, const MutableImageView& out);
  void Generate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                bool interpolates, const MutableImageView& out);

  FrameGenerationOptions options;
  PixelFormat format;
  InputConventions conventions;
  Prefilter prefilter;
  std::unique_ptr<GpuWorkspace> gpu;
  PrefilterPasses prefilter_passes;
  MotionFilterPasses motion_passes;
  int encode = -1;
  std::array<KindOfFrame, 2> kinds;  // extrapolation, interpolation; made when they are needed
  std::array<Slot, kSlots> slots;
  SerialExecutor executor;  // of the HUD

  int columns, table, generated;  // images
  int keys, camera;               // on the device
  int table_bytes, generated_bytes;
};

GpuFrameGeneration::State::State(const GpuDevice& device, const FrameGenerationOptions& chosen,
                                 PixelFormat texels, const InputConventions& stored)
    : options(chosen),
      format(texels),
      conventions(stored),
      prefilter(PrefiltersFrames(chosen) ? PrefilterOf(chosen.warp) : Prefilter{}),
      gpu(device.MakeWorkspace(texels)) {
  AddResources();
  AddSharedPasses();
  gpu->Run([&] { gpu->CopyToImage(table_bytes, table); });
}

// Images that the options do without are one texel: shaders name them, and do not read them.
void GpuFrameGeneration::State::AddResources() {
  const int width = options.width, height = options.height;
  const TexelFormat texels = TexelFormatOf(format);
  const bool filters = HasPrefilter(prefilter);
  const auto image = [&](bool is_needed, TexelFormat of) {
    return gpu->AddImage({of, is_needed ? width : 1, is_needed ? height : 1});
  };
  for (Slot& slot : slots) {
    slot.color = image(true, conventions.color_format);
    slot.depth = image(true, TexelFormat::kR32F);
    slot.motion = image(true, conventions.motion_format);
    slot.filtered = image(FiltersMotion(options), kFilteredMotionFormat);
    slot.codes = image(Encodes(), texels);
    slot.coefficients = image(filters, texels);
    slot.color_bytes = gpu->AddBufferOf(slot.color);
    slot.depth_bytes = gpu->AddBufferOf(slot.depth);
    slot.motion_bytes = gpu->AddBufferOf(slot.motion);
  }
  columns = image(filters, texels);
  generated = image(true, texels);
  table = AddTableImage(options.warp, *gpu);
  table_bytes = gpu->AddBufferOf(table);
  generated_bytes = gpu->AddBufferOf(generated);
  keys = gpu->AddBuffer({SplatKeyBytes(options), true});
  camera = AddCameraBuffer(*gpu);
  gpu->Allocate();
  const std::vector<float> nodes = TableTexels(options.warp);
  std::memcpy(gpu->BytesOf(table_bytes), nodes.data(), nodes.size() * sizeof(float));
}

void GpuFrameGeneration::State::AddSharedPasses() {
  std::vector<PrefilterPasses::Images> filtering;
  for (const Slot& slot : slots) filtering.push_back({Samples(slot), columns, slot.coefficients});
  prefilter_passes = PrefilterPasses(prefilter, options.width, options.height, filtering, *gpu);
  if (FiltersMotion(options)) {
    std::vector<MotionFilterPasses::Images> moving;
    for (const Slot& slot : slots) moving.push_back({slot.depth, slot.motion, slot.filtered});
    motion_passes =
        MotionFilterPasses(options.motion_filter_limit, conventions, camera, moving, *gpu);
  }
  if (!Encodes()) return;
  PassPlan plan = {.name = "encode",
                   .shader = Shader::kEncode,
                   .constants = Constants(false, false),
                   .sets = {},
                   .numbers_bytes = sizeof(GenerationNumbers),
                   .width = options.width,
                   .height = options.height};
  for (const Slot& slot : slots) plan.sets.push_back({Stored(slot.codes), Sampled(slot.color)});
  encode = gpu->AddPass(plan);
}

const KindOfFrame& GpuFrameGeneration::State::PassesOf(bool interpolates) {
  KindOfFrame& kind = kinds[interpolates ? 1 : 0];
  if (kind.generate >= 0) return kind;
  PassPlan plan = {.shader = Shader::kSplat,
                   .constants = {},
                   .sets = Sets(false),
                   .numbers_bytes = sizeof(GenerationNumbers),
                   .width = options.width,
                   .height = options.height};
  if (Splats(options)) {
    plan.name = "splat depth";
    plan.constants = Constants(interpolates, true);
    kind.splat_depth = gpu->AddPass(plan);
    plan.name = "splat source";
    plan.constants = Constants(interpolates, false);
    kind.splat_source = gpu->AddPass(plan);
  }
  plan.name = interpolates ? "interpolate" : "extrapolate";
  plan.shader = Shader::kGenerate;
  plan.constants = Constants(interpolates, false);
  plan.sets = Sets(true);
  kind.generate = gpu->AddPass(plan);
  return kind;
}

std::vector<std::vector<Binding>> GpuFrameGeneration::State::Sets(bool generates) const {
  std::vector<std::vector<Binding>> sets;
  for (std::size_t first = 0; first < kSlots; ++first) {
    const Slot &frame0 = slots[first], &frame1 = slots[1 - first];
    std::vector<Binding>& set = sets.emplace_back();
    set.push_back(Buffer(keys));
    set.push_back(Stored(generated));
    for (const auto member :
         {&Slot::depth, FiltersMotion(options) ? &Slot::filtered : &Slot::motion}) {
      set.push_back(Sampled(frame0.*member));
      set.push_back(Sampled(frame1.*member));
    }
    if (!generates) continue;
    for (const int image :
         {Samples(frame0), Samples(frame1), frame0.coefficients, frame1.coefficients, table}) {
      set.push_back(Sampled(image));
    }
  }
  return sets;
}

// constant_id 0, 1, ... of shaders/formulas.glsl, shaders/generation.glsl and shaders/splat.comp; 0
// to 6 are super resolution's but for the two that are shared.
std::vector<std::int32_t> GpuFrameGeneration::State::Constants(bool interpolates,
                                                               bool keeps_depth) const {
  const auto number = [](auto value) { return static_cast<std::int32_t>(value); };
  std::vector<std::int32_t> constants = {
      0, 0, number(DepthOf(options)), 0, 0, number(EncodingOf(options)), 0};
  AppendFilterConstants(options.warp, HasPrefilter(prefilter), &constants);
  for (const std::int32_t value :
       {number(conventions.depth_buffer), number(ModelOf(options)), number(Splats(options)),
        number(Refines(options)), number(FillOf(options)), number(GatesBrightness(options)),
        number(interpolates), number(keeps_depth)}) {
    constants.push_back(value);
  }
  return constants;
}

// The slot that holds the frame, or kSlots.
std::size_t GpuFrameGeneration::State::Find(const DisplayedFrame& frame, bool needs_color) const {
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (frame.id != 0 && slots[i].id == frame.id && (slots[i].has_color || !needs_color)) return i;
  }
  return kSlots;
}

void GpuFrameGeneration::State::Upload(const DisplayedFrame& frame, Slot& slot) {
  slot.id = frame.id;
  slot.has_color = frame.color.data != nullptr;
  if (slot.has_color) {
    PackColor(frame.color, conventions.color_format, gpu->BytesOf(slot.color_bytes));
  }
  PackDepth(frame.depth, gpu->BytesOf(slot.depth_bytes));
  PackMotion(frame.motion, conventions.motion_format, gpu->BytesOf(slot.motion_bytes));
}

// What is made of a frame once, however many are generated from it.
void GpuFrameGeneration::State::RecordFrame(std::size_t slot) {
  const Slot& s = slots[slot];
  gpu->CopyToImage(s.depth_bytes, s.depth);
  gpu->CopyToImage(s.motion_bytes, s.motion);
  motion_passes.Record(slot, options.width, options.height, *gpu);
  if (!s.has_color) return;
  gpu->CopyToImage(s.color_bytes, s.color);
  const GenerationNumbers unused = {};
  gpu->Record(encode, &unused, slot);
  prefilter_passes.Record(slot, *gpu);
}

GenerationNumbers GpuFrameGeneration::State::NumbersOf(const DisplayedFrame& frame0,
                                                       float alpha) const {
  const generation::GenerationJob job{options, false, alpha, false, {}, {}, {}, {}};
  return {.output_size = {options.width, options.height},
          .motion_scale = FiltersMotion(options) ? GpuFloat2{1, 1} : MotionScaleOf(conventions),
          .depth_a = conventions.depth_a,
          .depth_b = conventions.depth_b,
          .depth_threshold = job.depth_threshold(),
          .brightness_threshold = job.brightness_threshold(),
          .gate_width = options.gate_width,
          .filter_parameter = FilterParameterOf(options.warp),
          .alpha = alpha,
          .counts_motion0 = frame0.cut ? 0 : 1};
}

// `color` as it is, in the format of `out`.
void GpuFrameGeneration::State::Show(const ImageView& color, const MutableImageView& out) const {
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const void* pixel = color.At(x, y);
      generation::StoreRgb(Encodes() ? generation::LoadHdr(color.format, pixel)
                                     : generation::LoadRgb(color.format, pixel),
                           out.format, out.At(x, y));
    }
  }
}

void GpuFrameGeneration::State::Draw(const ImageView& hud, const MutableImageView& out) {
  if (hud.data != nullptr) DrawHud(hud, EncodingOf(options), executor, out);
}

// The order of the passes.
void GpuFrameGeneration::State::Generate(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                                         float alpha, bool interpolates,
                                         const MutableImageView& out) {
  const KindOfFrame& kind = PassesOf(interpolates);
  std::size_t slot0 = Find(frame0, interpolates), slot1 = Find(frame1, true);
  const bool is_new0 = slot0 == kSlots, is_new1 = slot1 == kSlots;
  if (is_new0) slot0 = is_new1 ? 0 : 1 - slot1;
  if (is_new1) slot1 = 1 - slot0;
  if (is_new0) Upload(frame0, slots[slot0]);
  if (is_new1) Upload(frame1, slots[slot1]);
  const GenerationNumbers numbers = NumbersOf(frame0, alpha);
  gpu->Run([&] {
    if (is_new0) RecordFrame(slot0);
    if (is_new1) RecordFrame(slot1);
    if (Splats(options)) gpu->FillBuffer(keys, kNoArrivalWord);
    for (const int pass : {kind.splat_depth, kind.splat_source, kind.generate})
      gpu->Record(pass, &numbers, slot0);
    gpu->CopyToBuffer(generated, generated_bytes);
  });
  UnpackColor(gpu->BytesOf(generated_bytes), format, out);
}

GpuFrameGeneration::GpuFrameGeneration(const GpuDevice& device,
                                       const FrameGenerationOptions& options, PixelFormat format,
                                       const InputConventions& conventions)
    : state_(std::make_unique<State>(device, options, format, conventions)) {}

GpuFrameGeneration::~GpuFrameGeneration() = default;

void GpuFrameGeneration::Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                                     float alpha, const MutableImageView& out) {
  if (frame1.cut) {
    state_->Show(alpha < 0.5f ? frame0.color : frame1.color, out);
  } else {
    state_->Generate(frame0, frame1, alpha, true, out);
  }
  state_->Draw(alpha < 0.5f ? frame0.hud : frame1.hud, out);
}

void GpuFrameGeneration::Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                                     float alpha, const MutableImageView& out) {
  if (frame1.cut) {
    state_->Show(frame1.color, out);
  } else {
    state_->Generate(frame0, frame1, alpha, false, out);
  }
  state_->Draw(frame1.hud, out);
}

std::vector<PassTime> GpuFrameGeneration::Times() const { return state_->gpu->Times(); }

std::size_t GpuFrameGeneration::MemoryBytes() const { return state_->gpu->bytes(); }

}  // namespace warplut
