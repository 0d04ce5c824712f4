// The devices that run methods: the processor, or a GPU.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "train/replay/mode_run.h"

namespace warplut {

class GpuDevice;

// As --device takes them; the processor first.
std::vector<std::string> DeviceNames();
// Those that are GPUs, each by another API.
std::vector<std::string> GpuDeviceNames();

// An Error if the build has nothing for `device`. Opens no device.
void CheckDevice(const std::string& device);

// Opens a GPU; null for the processor. CheckDevice holds. GpuError (runtime/gpu/gpu_device.h) where
// there is none. Frames of the device and their times include uploads and downloads; colour is the
// host's, so frames pass through its memory from one pass to the other.
std::unique_ptr<ModeDevice> OpenDevice(const std::string& device);

// The GPU alone. CheckDevice holds for `device`, of GpuDeviceNames.
std::shared_ptr<const GpuDevice> OpenGpu(const std::string& device);

}  // namespace warplut
