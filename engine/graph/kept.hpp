// Inside of row 3: what the executor keeps from frame to frame, and the real objects that stand behind this frame's resources.
#pragma once
#include "engine/graph/executor.hpp"
#include <array>
#include <map>

namespace afterglow
{
struct KeptImage {
    GpuImage image;
    bool taken = false; // by this frame
};

struct KeptBuffer {
    GpuBuffer buffer;
    bool taken = false;
};

struct KeptHistory {
    std::array<GpuImage, 2> images;
    std::uint32_t current = 0;
    bool taken = false;
};

// This frame's objects, by physical index; null where the other kind stands.
struct Objects {
    std::vector<const GpuImage*> images;
    std::vector<const GpuBuffer*> buffers;
};

struct Kept {
    std::vector<std::unique_ptr<KeptImage>> images;
    std::vector<std::unique_ptr<KeptBuffer>> buffers;
    std::map<std::string, KeptHistory> histories;
};

// Takes what fits from what is kept, makes what is missing, and lets go of what this frame has no use for.
Objects provide(Memory& memory, Kept& kept, const Graph& graph, const Schedule& schedule);
}
