// Compile, provide, record, submit, wait, count.
#include "engine/graph/executor.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/graph/frame_commands.hpp"

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
    FrameCommands& frame = state_->frame;
    frame.begin(schedule.passes.size());
    frame.timestamp();
    for (std::size_t i = 0; i < schedule.passes.size(); ++i) {
        const PassData& pass = graph.passes[schedule.passes[i].pass];
        PassStats& own = stats.passes.emplace_back(describePass(pass, graph, schedule));
        recordBarriers(frame.commands, schedule.passes[i].barriers, objects);
        recordPass(frame, pass, pipelines[i], graph, schedule, objects, scene.set, own);
        frame.timestamp();
        stats.draws += own.draws;
        stats.triangles += own.triangles;
    }
    recordBarriers(frame.commands, schedule.last, objects);
    frame.submit();

    const std::vector<double> milliseconds = frame.milliseconds();
    for (std::size_t i = 0; i < milliseconds.size(); ++i) {
        stats.passes[i].milliseconds = milliseconds[i];
        stats.milliseconds += milliseconds[i];
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
