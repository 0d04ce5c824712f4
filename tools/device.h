// The devices that run methods: the processor, or a GPU.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "train/replay/mode_run.h"

namespace warplut {

// As --device takes them; the processor first.
std::vector<std::string> DeviceNames();

// An Error if the build has nothing for `device`. Opens no device.
void CheckDevice(const std::string& device);

// Opens "vulkan"; null for the processor. CheckDevice holds. GpuError (runtime/gpu/vulkan_device.h)
// where there is none. Frames of the device and their times include uploads and downloads; colour
// is the host's, so frames pass through its memory from one pass to the other.
std::unique_ptr<ModeDevice> OpenDevice(const std::string& device);

}  // namespace warplut
