// The functions of EGL and OpenGL ES that are used here, loaded where a program runs: it needs no
// driver to start.
#pragma once

#define EGL_EGL_PROTOTYPES 0
#define GL_GLES_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>
// After gl32.h.
#include <GLES2/gl2ext.h>

#define WARPLUT_EGL_FUNCTIONS(X)                      \
  X(PFNEGLBINDAPIPROC, BindAPI)                       \
  X(PFNEGLCREATECONTEXTPROC, CreateContext)           \
  X(PFNEGLDESTROYCONTEXTPROC, DestroyContext)         \
  X(PFNEGLGETPLATFORMDISPLAYPROC, GetPlatformDisplay) \
  X(PFNEGLINITIALIZEPROC, Initialize)                 \
  X(PFNEGLMAKECURRENTPROC, MakeCurrent)               \
  X(PFNEGLQUERYSTRINGPROC, QueryString)               \
  X(PFNEGLTERMINATEPROC, Terminate)

#define WARPLUT_GLES_FUNCTIONS(X)                            \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                   \
  X(PFNGLBINDSAMPLERPROC, BindSampler)                       \
  X(PFNGLDELETESAMPLERSPROC, DeleteSamplers)                 \
  X(PFNGLGENSAMPLERSPROC, GenSamplers)                       \
  X(PFNGLATTACHSHADERPROC, AttachShader)                     \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                         \
  X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                 \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)               \
  X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)             \
  X(PFNGLBINDTEXTUREPROC, BindTexture)                       \
  X(PFNGLBUFFERDATAPROC, BufferData)                         \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus) \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                   \
  X(PFNGLCOPYBUFFERSUBDATAPROC, CopyBufferSubData)           \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                   \
  X(PFNGLCREATESHADERPROC, CreateShader)                     \
  X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback)     \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                   \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)         \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                   \
  X(PFNGLDELETESHADERPROC, DeleteShader)                     \
  X(PFNGLDELETETEXTURESPROC, DeleteTextures)                 \
  X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute)               \
  X(PFNGLENABLEPROC, Enable)                                 \
  X(PFNGLFINISHPROC, Finish)                                 \
  X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)     \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                         \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)               \
  X(PFNGLGENTEXTURESPROC, GenTextures)                       \
  X(PFNGLGETERRORPROC, GetError)                             \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                       \
  X(PFNGLGETINTEGER64VPROC, GetInteger64v)                   \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)           \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                     \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)             \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                       \
  X(PFNGLGETSTRINGPROC, GetString)                           \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                       \
  X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                   \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                       \
  X(PFNGLREADPIXELSPROC, ReadPixels)                         \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                     \
  X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri)           \
  X(PFNGLTEXSTORAGE2DPROC, TexStorage2D)                     \
  X(PFNGLTEXSTORAGE3DPROC, TexStorage3D)                     \
  X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                   \
  X(PFNGLTEXSUBIMAGE3DPROC, TexSubImage3D)                   \
  X(PFNGLUSEPROGRAMPROC, UseProgram)

// Those of GL_EXT_disjoint_timer_query.
#define WARPLUT_GLES_TIMERS(X)                   \
  X(PFNGLBEGINQUERYEXTPROC, BeginQueryEXT)       \
  X(PFNGLDELETEQUERIESEXTPROC, DeleteQueriesEXT) \
  X(PFNGLENDQUERYEXTPROC, EndQueryEXT)           \
  X(PFNGLGENQUERIESEXTPROC, GenQueriesEXT)       \
  X(PFNGLGETQUERYOBJECTUI64VEXTPROC, GetQueryObjectui64vEXT)

namespace warplut {

#define WARPLUT_MEMBER(type, name) type name = nullptr;

struct EglApi {
  WARPLUT_EGL_FUNCTIONS(WARPLUT_MEMBER)
};

struct GlesApi {
  WARPLUT_GLES_FUNCTIONS(WARPLUT_MEMBER)
  WARPLUT_GLES_TIMERS(WARPLUT_MEMBER)  // null where the driver lacks the extension
};

#undef WARPLUT_MEMBER

// Loads libEGL.so.1. A GpuError if it, or a function, is missing.
EglApi LoadEgl();
// After LoadEgl. A GpuError if a function is missing.
GlesApi LoadGles();

}  // namespace warplut
