// Compile, provide, record, submit, wait, count.
#include "engine/graph/executor.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/graph/frame_commands.hpp"
#include <algorithm>
#include <cstring>

namespace afterglow
{
struct Executor::State {
    explicit State(Device& device) : frame(device) {}
    FrameCommands frame;
    Kept kept;
    // The last run: what stands behind each resource, null when culled.
    std::vector<const GpuImage*> images;
    std::vector<const GpuBuffer*> buffers;
};

Executor::Executor(Gpu& g) : gpu(g), state_(std::make_unique<State>(g.device)) {}
Executor::~Executor() = default;

// The formats come from what the pass draws to.
static PipelineKey keyOf(const PassData& pass, const Graph& graph)
{
    PipelineKey key = pass.key;
    for (const Access& access : pass.accesses) {
        if (isColorUse(access.use))
            key.colors.push_back(access.resource == kNoResource ? VK_FORMAT_UNDEFINED : graph.resources[access.resource].shape.format);
        if (isDepthUse(access.use)) key.depth = graph.resources[access.resource].shape.format;
    }
    return key;
}

static PassStats describePass(const PassData& pass, const Graph& graph, const Schedule& schedule)
{
    PassStats stats;
    stats.name = pass.name;
    for (const Access& access : pass.accesses) {
        if (access.resource == kNoResource) continue;
        const Resource& resource = graph.resources[access.resource];
        if (reads(access.use)) stats.reads.push_back(resource.name);
        if (!writes(access.use)) continue;
        stats.writes.push_back(resource.name);
        stats.bytes += schedule.physicals[schedule.physicalOf[access.resource]].bytes;
    }
    return stats;
}

namespace
{
// Scheduled passes [begin, end) that are submitted together; the last ones are never repeated, and may be none.
struct Stretch {
    std::size_t begin, end;
    const Repeat* repeat;
};
}

static std::vector<Stretch> stretchesOf(const Graph& graph, const Schedule& schedule)
{
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < schedule.passes.size(); ++i) {
        const std::uint32_t pass = schedule.passes[i].pass;
        const auto found = std::find_if(graph.repeats.begin(), graph.repeats.end(),
                                        [&](const Repeat& repeat) { return pass >= repeat.first && pass < repeat.last; });
        const Repeat* repeat = found == graph.repeats.end() ? nullptr : &*found;
        if (stretches.empty() || stretches.back().repeat != repeat) stretches.push_back({i, i, repeat});
        stretches.back().end = i + 1;
    }
    if (stretches.empty() || stretches.back().repeat) stretches.push_back({schedule.passes.size(), schedule.passes.size(), nullptr});
    return stretches;
}

// Passes of one name are one row: the steps of a loop that are declared one after the other.
static std::vector<PassStats> byName(const std::vector<PassStats>& passes)
{
    std::vector<PassStats> rows;
    for (const PassStats& pass : passes) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const PassStats& earlier) { return earlier.name == pass.name; });
        if (row == rows.end()) {
            rows.push_back(pass);
            continue;
        }
        row->milliseconds += pass.milliseconds;
        row->draws += pass.draws;
        row->triangles += pass.triangles;
    }
    return rows;
}

FrameStats Executor::run(const Graph& graph, const SceneSet& scene)
{
    const Schedule schedule = compile(graph);
    std::vector<const Pipeline*> pipelines;
    for (const ScheduledPass& scheduled : schedule.passes) {
        const PassData& pass = graph.passes[scheduled.pass];
        pipelines.push_back(pass.key.shaders.empty() ? nullptr : &gpu.pipelines.get(keyOf(pass, graph), scene.layout));
    }
    const Objects objects = provide(gpu.memory, state_->kept, graph, schedule);
    state_->images.assign(graph.resources.size(), nullptr);
    state_->buffers.assign(graph.resources.size(), nullptr);
    for (std::size_t r = 0; r < graph.resources.size(); ++r) {
        if (schedule.physicalOf[r] == kNoResource) continue;
        state_->images[r] = objects.images[schedule.physicalOf[r]];
        state_->buffers[r] = objects.buffers[schedule.physicalOf[r]];
    }

    FrameStats stats;
    for (const ScheduledPass& scheduled : schedule.passes)
        stats.passes.push_back(describePass(graph.passes[scheduled.pass], graph, schedule));
    FrameCommands& frame = state_->frame;
    const std::vector<Stretch> stretches = stretchesOf(graph, schedule);
    constexpr VkBufferCopy kWord{0, 0, sizeof(std::uint32_t)};
    const GpuBuffer left = graph.repeats.empty() ? GpuBuffer{} : gpu.memory.buffer("left", kWord.size, 0, Where::host);
    const auto submit = [&](const Stretch& stretch) {
        frame.begin(stretch.end - stretch.begin);
        frame.timestamp();
        for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
            recordBarriers(frame.commands, schedule.passes[i].barriers, objects);
            recordPass(frame, graph.passes[schedule.passes[i].pass], pipelines[i], graph, schedule, objects, scene.set, stats.passes[i]);
            frame.timestamp();
        }
        if (&stretch == &stretches.back()) recordBarriers(frame.commands, schedule.last, objects);
        if (stretch.repeat) {
            recordEverythingSeen(frame.commands); // by the copy, and by the next time
            vkCmdCopyBuffer(frame.commands, state_->buffers[stretch.repeat->left]->buffer, left.buffer, 1, &kWord);
        }
        frame.submit();
        const std::vector<double> milliseconds = frame.milliseconds();
        for (std::size_t i = 0; i < milliseconds.size(); ++i) stats.passes[stretch.begin + i].milliseconds += milliseconds[i];
    };
    for (const Stretch& stretch : stretches) {
        std::uint32_t word = 0;
        do {
            submit(stretch);
            if (stretch.repeat) std::memcpy(&word, left.mapped, sizeof(word));
        } while (word != 0);
    }
    stats.passes = byName(stats.passes);
    for (const PassStats& pass : stats.passes) {
        stats.milliseconds += pass.milliseconds;
        stats.draws += pass.draws;
        stats.triangles += pass.triangles;
    }
    stats.culled = schedule.culled;
    stats.pipelines = gpu.pipelines.count();
    stats.gpuBytes = gpu.memory.bytes();
    return stats;
}

const GpuImage& Executor::image(const Texture& output) const
{
    check(output.index < state_->images.size() && state_->images[output.index], "this texture is no output of the last run");
    return *state_->images[output.index];
}

const GpuBuffer& Executor::buffer(const Buffer& output) const
{
    check(output.index < state_->buffers.size() && state_->buffers[output.index], "this buffer is no output of the last run");
    return *state_->buffers[output.index];
}

Image Executor::download(const Texture& output) const { return readback(gpu.memory, image(output), output.range.mip, output.range.layer); }

std::vector<std::uint8_t> Executor::download(const Buffer& output) const
{
    std::vector<std::uint8_t> bytes = readback(gpu.memory, buffer(output));
    bytes.resize(output.bytes);
    return bytes;
}
}
