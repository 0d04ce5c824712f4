#include "runtime/gpu/gles/gles_workspace.h"

#include <algorithm>
#include <cstring>

#include "luts/half.h"
#include "runtime/gpu/gles/gles_program.h"

namespace warplut {
namespace {

constexpr std::size_t kChunkBytes = 1 << 20;

// After a pass: what it stored is read by passes, copied, or overwritten.
constexpr GLbitfield kAfterPass = GL_TEXTURE_FETCH_BARRIER_BIT |
                                  GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                  GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                                  GL_BUFFER_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT;

struct GlesFormat {
  GLenum internal, channels, type;
};

GlesFormat FormatOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::kR8:
      return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
    case TexelFormat::kR16F:
      return {GL_R16F, GL_RED, GL_HALF_FLOAT};
    case TexelFormat::kR32F:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case TexelFormat::kRg16F:
      return {GL_RG16F, GL_RG, GL_HALF_FLOAT};
    case TexelFormat::kRg32F:
      return {GL_RG32F, GL_RG, GL_FLOAT};
    case TexelFormat::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::kRgba16F:
      return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case TexelFormat::kRgba32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case TexelFormat::kR11G11B10F:
      return {GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV};
  }
  return {};
}

GLenum TargetOf(const ImagePlan& plan) {
  return plan.layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

// Texels of four floats as texels of a format that is stored to.
void PackTexels(const std::vector<float>& texels, TexelFormat format, std::byte* to) {
  if (format == TexelFormat::kRgba32F) {
    std::memcpy(to, texels.data(), texels.size() * sizeof(float));
  } else if (format == TexelFormat::kR32F) {
    for (std::size_t i = 0; i < texels.size(); i += 4, to += sizeof(float))
      std::memcpy(to, &texels[i], sizeof(float));
  } else {
    for (const float channel : texels) {
      const std::uint16_t half = FloatToHalf(channel);
      std::memcpy(to, &half, sizeof(half));
      to += sizeof(half);
    }
  }
}

}  // namespace

GlesWorkspace::~GlesWorkspace() {
  try {
    const GlesDevice::Current current(device_);
    const GlesApi& gl = device_.gl();
    for (const Pass& pass : passes_) gl.DeleteProgram(pass.program);
    gl.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    gl.DeleteBuffers(static_cast<GLsizei>(storage_.size()), storage_.data());
    gl.DeleteSamplers(1, &nearest_);
    gl.DeleteSamplers(1, &linear_);
    gl.DeleteBuffers(1, &numbers_);
    gl.DeleteBuffers(1, &chunk_);
    gl.DeleteFramebuffers(1, &framebuffer_);
  } catch (const GpuError&) {
    // A context that is lost has nothing to free.
  }
}

void GlesWorkspace::Allocate() {
  const GlesDevice::Current current(device_);
  const GlesApi& gl = device_.gl();
  textures_.resize(images().size());
  gl.GenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
  for (std::size_t i = 0; i < textures_.size(); ++i) CreateTexture(images()[i], textures_[i]);
  storage_.resize(buffers().size());
  contents_.resize(buffers().size());
  for (std::size_t i = 0; i < buffers().size(); ++i) {
    const BufferPlan& plan = buffers()[i];
    if (!plan.on_device) {
      contents_[i].resize(plan.size);
      continue;
    }
    gl.GenBuffers(1, &storage_[i]);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, storage_[i]);
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(plan.size), nullptr,
                  GL_DYNAMIC_COPY);
  }
  nearest_ = MakeSampler(GL_NEAREST);
  linear_ = MakeSampler(GL_LINEAR);
  gl.GenBuffers(1, &numbers_);
  gl.GenBuffers(1, &chunk_);
  gl.GenFramebuffers(1, &framebuffer_);
  // Rows in memory follow each other without padding.
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  device_.Check("to allocate " + std::to_string(bytes()) + " bytes");
}

void GlesWorkspace::CreateTexture(const ImagePlan& plan, GLuint texture) const {
  const GlesApi& gl = device_.gl();
  const GLenum target = TargetOf(plan), internal = FormatOf(plan.format).internal;
  gl.BindTexture(target, texture);
  if (plan.layers > 0) {
    gl.TexStorage3D(target, 1, internal, plan.width, plan.height, plan.layers);
  } else {
    gl.TexStorage2D(target, 1, internal, plan.width, plan.height);
  }
}

// Beyond the edges are the outermost texels. A texture of 32-bit floats that would be filtered
// gives nothing.
GLuint GlesWorkspace::MakeSampler(GLenum filter) const {
  const GlesApi& gl = device_.gl();
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return sampler;
}

int GlesWorkspace::AddPass(const PassPlan& plan) {
  const GlesDevice::Current current(device_);
  const std::string source = SpecialisedSource(EsslOf(plan.shader, format_), plan.constants);
  passes_.push_back({plan, MakeProgram(device_, plan.name, source)});
  return static_cast<int>(passes_.size()) - 1;
}

void GlesWorkspace::Run(const std::function<void()>& record) {
  const GlesDevice::Current current(device_);
  record();
  device_.gl().Finish();
  ReadTimes();
  device_.Check("to run a frame");
}

void GlesWorkspace::RecordGrid(int pass, const void* numbers, std::size_t set, int width,
                               int height) {
  if (pass < 0) return;
  const GlesApi& gl = device_.gl();
  const Pass& recorded = passes_[static_cast<std::size_t>(pass)];
  const PassPlan& plan = recorded.plan;
  gl.UseProgram(recorded.program);
  for (std::size_t i = 0; i < plan.sets[set].size(); ++i)
    Bind(plan.sets[set][i], static_cast<GLuint>(i));
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, numbers_);
  gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(plan.numbers_bytes), numbers,
                GL_STREAM_DRAW);
  TimedPass timed = {plan.name, 0};
  if (device_.has_times()) {
    gl.GenQueriesEXT(1, &timed.query);
    gl.BeginQueryEXT(GL_TIME_ELAPSED_EXT, timed.query);
  }
  gl.DispatchCompute(static_cast<GLuint>(plan.groups_x(width)),
                     static_cast<GLuint>(plan.groups_y(height)), 1);
  if (device_.has_times()) gl.EndQueryEXT(GL_TIME_ELAPSED_EXT);
  run_.push_back(timed);
  gl.MemoryBarrier(kAfterPass);
}

void GlesWorkspace::Bind(const Binding& binding, GLuint place) const {
  const GlesApi& gl = device_.gl();
  const auto index = static_cast<std::size_t>(binding.index);
  switch (binding.use) {
    case Binding::Use::kBuffer:
      gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, place, storage_[index]);
      break;
    case Binding::Use::kStored:
      gl.BindImageTexture(place, textures_[index], 0, GL_FALSE, 0, GL_WRITE_ONLY,
                          FormatOf(images()[index].format).internal);
      break;
    case Binding::Use::kSampled:
    case Binding::Use::kFiltered:
      gl.BindSampler(place, binding.use == Binding::Use::kFiltered ? linear_ : nearest_);
      gl.ActiveTexture(GL_TEXTURE0 + place);
      gl.BindTexture(TargetOf(images()[index]), textures_[index]);
      break;
  }
}

// The times of this Run, after its end.
void GlesWorkspace::ReadTimes() {
  times_.clear();
  const GlesApi& gl = device_.gl();
  for (const TimedPass& timed : run_) {
    if (timed.query == 0) continue;
    GLuint64 nanoseconds = 0;
    gl.GetQueryObjectui64vEXT(timed.query, GL_QUERY_RESULT, &nanoseconds);
    gl.DeleteQueriesEXT(1, &timed.query);
    times_.push_back({timed.name, static_cast<double>(nanoseconds) * 1e-6});
  }
  run_.clear();
}

void GlesWorkspace::CopyToCorner(int buffer, int image, int width, int height) {
  const GlesApi& gl = device_.gl();
  const ImagePlan& plan = this->image(image);
  const GlesFormat format = FormatOf(plan.format);
  const GLenum target = TargetOf(plan);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(target, textures_[static_cast<std::size_t>(image)]);
  if (plan.layers > 0) {
    gl.TexSubImage3D(target, 0, 0, 0, 0, width, height, plan.layers, format.channels, format.type,
                     BytesOf(buffer));
  } else {
    gl.TexSubImage2D(target, 0, 0, 0, width, height, format.channels, format.type, BytesOf(buffer));
  }
}

// Every device reads images of floats as four floats; other layouts are the driver's choice.
void GlesWorkspace::CopyToBuffer(int image, int buffer) {
  const GlesApi& gl = device_.gl();
  const ImagePlan& plan = this->image(image);
  std::vector<float> texels(4 * static_cast<std::size_t>(plan.width) *
                            static_cast<std::size_t>(plan.height));
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                          textures_[static_cast<std::size_t>(image)], 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw GpuError("the device " + device_.name() + " cannot read images of the format " +
                   Name(plan.format));
  }
  gl.ReadPixels(0, 0, plan.width, plan.height, GL_RGBA, GL_FLOAT, texels.data());
  PackTexels(texels, plan.format, BytesOf(buffer));
}

// By copies of a chunk: there is no command that fills.
void GlesWorkspace::FillBuffer(int buffer, std::uint32_t value) {
  const GlesApi& gl = device_.gl();
  const std::size_t size = this->buffer(buffer).size, chunk = std::min(size, kChunkBytes);
  const std::vector<std::uint32_t> words(chunk / sizeof(value), value);
  gl.BindBuffer(GL_COPY_READ_BUFFER, chunk_);
  gl.BufferData(GL_COPY_READ_BUFFER, static_cast<GLsizeiptr>(chunk), words.data(), GL_STREAM_COPY);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, storage_[static_cast<std::size_t>(buffer)]);
  for (std::size_t at = 0; at < size; at += chunk) {
    gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, static_cast<GLintptr>(at),
                         static_cast<GLsizeiptr>(std::min(chunk, size - at)));
  }
}

}  // namespace warplut
