#include "runtime/gpu/gles/gles_device.h"

#include <string_view>

#include "runtime/gpu/gles/gles_workspace.h"

namespace warplut {
namespace {

std::string ReasonOf(GLenum error) {
  switch (error) {
    case GL_OUT_OF_MEMORY:
      return "there is not enough memory";
    case GL_CONTEXT_LOST:
      return "the device was lost";
    default:
      return "OpenGL ES returned " + std::to_string(error);
  }
}

void GL_APIENTRY Collect(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
                         const GLchar* message, const void* messages) {
  // Those of type other tell of the driver's compiler, not of this program.
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_OTHER) return;
  static_cast<std::vector<std::string>*>(const_cast<void*>(messages))
      ->emplace_back(message, static_cast<std::size_t>(length));
}

}  // namespace

GlesDevice::Current::Current(const GlesDevice& device) : device_(device), lock_(device.mutex_) {
  if (device.egl_.MakeCurrent(device.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, device.context_) !=
      EGL_TRUE) {
    throw GpuError("the GPU failed to take up its OpenGL ES context");
  }
}

GlesDevice::Current::~Current() {
  device_.egl_.MakeCurrent(device_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

GlesDevice::GlesDevice(const DeviceOptions& options) : egl_(LoadEgl()) {
  try {
    CreateContext(options);
    gl_ = LoadGles();
    const Current current(*this);
    ReadLimits();
    if (!options.validate) return;
    gl_.Enable(GL_DEBUG_OUTPUT);
    gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl_.DebugMessageCallback(Collect, &messages_);
  } catch (...) {
    Destroy();
    throw;
  }
}

GlesDevice::~GlesDevice() { Destroy(); }

void GlesDevice::Destroy() {
  if (context_ != EGL_NO_CONTEXT) egl_.DestroyContext(display_, context_);
  if (display_ != EGL_NO_DISPLAY) egl_.Terminate(display_);
}

void GlesDevice::CreateContext(const DeviceOptions& options) {
  const char* const platforms = egl_.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (platforms == nullptr ||
      std::string_view(platforms).find("EGL_MESA_platform_surfaceless") == std::string_view::npos) {
    throw GpuError("there is no OpenGL ES driver on this machine that works without a window");
  }
  display_ = egl_.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  EGLint major = 0, minor = 0;
  if (display_ == EGL_NO_DISPLAY || egl_.Initialize(display_, &major, &minor) != EGL_TRUE) {
    throw GpuError("there is no device with OpenGL ES on this machine");
  }
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               2,
                               EGL_CONTEXT_OPENGL_DEBUG,
                               options.validate ? EGL_TRUE : EGL_FALSE,
                               EGL_NONE};
  if (egl_.BindAPI(EGL_OPENGL_ES_API) == EGL_TRUE) {
    context_ = egl_.CreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  }
  if (context_ == EGL_NO_CONTEXT) {
    throw GpuError("the OpenGL ES driver of this machine has not version 3.2, which was expected");
  }
}

void GlesDevice::ReadLimits() {
  name_ = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest_image_);
  GLint64 bytes = 0;
  gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  largest_buffer_ = static_cast<std::size_t>(bytes);
  const std::string_view extensions(reinterpret_cast<const char*>(gl_.GetString(GL_EXTENSIONS)));
  has_times_ = extensions.find("GL_EXT_disjoint_timer_query") != std::string_view::npos;
  Check("to tell its limits");
}

void GlesDevice::Check(const std::string& what) const {
  const GLenum error = gl_.GetError();
  if (error == GL_NO_ERROR) return;
  throw GpuError("the GPU failed " + what + ": " + ReasonOf(error));
}

std::unique_ptr<GpuWorkspace> GlesDevice::MakeWorkspace(PixelFormat format) const {
  return std::make_unique<GlesWorkspace>(*this, format);
}

}  // namespace warplut
