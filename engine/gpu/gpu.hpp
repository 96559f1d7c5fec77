// All of row 2 in one value, in the order in which it is built: Gpu gpu(deviceOptions("")); Executor executor(gpu);
#pragma once
#include "engine/gpu/device.hpp"
#include "engine/gpu/memory.hpp"
#include "engine/gpu/pipeline.hpp"

namespace afterglow
{
struct Gpu {
    explicit Gpu(const DeviceOptions& options = {}) : device(options), memory(device), pipelines(memory) {}
    Device device;
    Memory memory;
    Pipelines pipelines;
};
}
