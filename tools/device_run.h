// Runs a method on the processor or on a GPU.
#pragma once

#include <string>
#include <vector>

#include "train/replay/mode_run.h"

namespace warplut {

// As --device takes them.
std::vector<std::string> DeviceNames();

// An Error if `device` has no passes for the method, or the build none for the device. Opens no
// device.
void CheckDevice(const std::string& device, const MethodInfo& method);

// RunMode on the device "cpu" or "vulkan"; CheckDevice holds. Frames and their times are those of
// the device, uploads and downloads included. An Error names what the device cannot do; GpuError
// (runtime/gpu/vulkan_device.h) where there is none or it fails.
void RunModeOn(const std::string& device, const Clip& clip, const ModeRunOptions& options,
               Executor& executor, const ShownFrameSink& sink);

}  // namespace warplut
