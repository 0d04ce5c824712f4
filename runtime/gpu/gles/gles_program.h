// A compute shader of OpenGL ES with its choices.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "runtime/gpu/gles/gles_device.h"

namespace warplut {

// `source` with the values of its specialisation constants: spirv-cross writes constant n as
// "#define SPIRV_CROSS_CONSTANT_ID_n DEFAULT", of a boolean with the default true or false. Those
// that the source lacks do nothing.
std::string SpecialisedSource(std::string_view source, std::span<const std::int32_t> constants);

// The linked program of a pass. A GpuError with the first line that the compiler says if it does
// not take the source. In GlesDevice::Current.
GLuint MakeProgram(const GlesDevice& device, const std::string& pass, const std::string& source);

}  // namespace warplut
