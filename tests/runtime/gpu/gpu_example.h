// The example for GPUs, on the API of this program.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {

struct Printed {
  std::string text;
  int code = 0;
};

inline Printed OutputOf(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  Printed printed;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    printed.text += static_cast<char>(c);
  printed.code = WEXITSTATUS(pclose(pipe));
  return printed;
}

inline const std::string kGpuExample =
    std::string(GPU_EXAMPLE) + (kTestedApi == GpuApi::kGles ? " gles" : "");

}  // namespace warplut
