#include "runtime/gpu/gles/gles_api.h"

#include <dlfcn.h>

#include <string>

#include "runtime/gpu/gpu_device.h"

namespace warplut {
namespace {

using GetProcAddress = PFNEGLGETPROCADDRESSPROC;

// The library stays loaded: its drivers cannot be unloaded safely.
void* Egl() {
  static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  return library;
}

GetProcAddress Loader() {
  return reinterpret_cast<GetProcAddress>(dlsym(Egl(), "eglGetProcAddress"));
}

template <class Function>
void Load(const std::string& name, void* address, Function* function) {
  if (address == nullptr) throw GpuError("the OpenGL ES of this machine has no function " + name);
  *function = reinterpret_cast<Function>(address);
}

}  // namespace

EglApi LoadEgl() {
  if (Egl() == nullptr) {
    throw GpuError("there is no OpenGL ES on this machine: the library libEGL.so.1 is missing");
  }
  EglApi egl;
#define WARPLUT_LOAD(type, name) Load("egl" #name, dlsym(Egl(), "egl" #name), &egl.name);
  WARPLUT_EGL_FUNCTIONS(WARPLUT_LOAD)
#undef WARPLUT_LOAD
  return egl;
}

GlesApi LoadGles() {
  GetProcAddress address = nullptr;
  Load("eglGetProcAddress", reinterpret_cast<void*>(Loader()), &address);
  GlesApi gl;
#define WARPLUT_LOAD(type, name) \
  Load("gl" #name, reinterpret_cast<void*>(address("gl" #name)), &gl.name);
  WARPLUT_GLES_FUNCTIONS(WARPLUT_LOAD)
#undef WARPLUT_LOAD
#define WARPLUT_LOAD(type, name) gl.name = reinterpret_cast<type>(address("gl" #name));
  WARPLUT_GLES_TIMERS(WARPLUT_LOAD)
#undef WARPLUT_LOAD
  return gl;
}

}  // namespace warplut
