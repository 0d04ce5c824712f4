#include "runtime/gpu/gles/gles_program.h"

namespace warplut {
namespace {

constexpr GLsizei kLongestLog = 1024;

std::string FirstLine(const char* log) {
  const std::string text(log);
  return text.substr(0, text.find('\n'));
}

}  // namespace

std::string SpecialisedSource(std::string_view source, std::span<const std::int32_t> constants) {
  std::string specialised(source);
  for (std::size_t n = 0; n < constants.size(); ++n) {
    const std::string define = "#define SPIRV_CROSS_CONSTANT_ID_" + std::to_string(n) + " ";
    std::size_t at = specialised.find(define);
    if (at == std::string::npos) continue;
    at += define.size();
    const std::size_t length = specialised.find('\n', at) - at;
    const std::string_view standard = std::string_view(specialised).substr(at, length);
    const bool is_boolean = standard == "true" || standard == "false";
    const std::string value =
        is_boolean ? (constants[n] != 0 ? "true" : "false") : std::to_string(constants[n]);
    specialised.replace(at, length, value);
  }
  return specialised;
}

GLuint MakeProgram(const GlesDevice& device, const std::string& pass, const std::string& source) {
  const GlesApi& gl = device.gl();
  const GLuint shader = gl.CreateShader(GL_COMPUTE_SHADER);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  GLint is_compiled = GL_FALSE, is_linked = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
  GLchar log[kLongestLog] = "";
  if (is_compiled != GL_TRUE) {
    gl.GetShaderInfoLog(shader, kLongestLog, nullptr, log);
  } else if (is_linked != GL_TRUE) {
    gl.GetProgramInfoLog(program, kLongestLog, nullptr, log);
  }
  gl.DeleteShader(shader);
  if (is_compiled == GL_TRUE && is_linked == GL_TRUE) return program;
  gl.DeleteProgram(program);
  throw GpuError("the GPU failed to compile the pass " + pass + ": " + FirstLine(log));
}

}  // namespace warplut
