// The only place where a frame's barriers come from. Every mip of every layer of every place is followed through the passes: a barrier
// stands where a layout changes, where something reads or overwrites what was written, or where something overwrites what was read.
#include "engine/core/error.hpp"
#include "engine/graph/schedule.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
// What the past of one mip of one layer asks of its next access.
struct Past {
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkPipelineStageFlags2 wroteStages = 0, readStages = 0; // since, and including, the last write
    VkAccessFlags2 wroteAccess = 0;
    VkPipelineStageFlags2 seenStages = 0; // that see the last write already
    VkAccessFlags2 seenAccess = 0;
    bool written = false; // holds something of its resource

    State before() const { return {wroteStages | readStages, wroteAccess, layout}; }
};

struct Place {
    std::uint32_t resource = kNoResource; // whose texels it holds now
    std::uint32_t mips = 1, layers = 1;
    std::vector<Past> pasts; // mip * layers + layer
    Past& at(std::uint32_t mip, std::uint32_t layer) { return pasts[mip * layers + layer]; }
};
}

constexpr VkAccessFlags2 kWriteAccess = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
                                        VK_ACCESS_2_MEMORY_WRITE_BIT;

static bool sees(const Past& past, const State& wanted)
{
    return (past.seenStages & wanted.stages) == wanted.stages && (past.seenAccess & wanted.access) == wanted.access;
}

// Does this access need a barrier, and if so, after what?
static bool needsBarrier(const Past& past, const State& wanted)
{
    if (past.layout != wanted.layout) return true;
    if (wanted.access & kWriteAccess) return past.wroteStages || past.readStages;
    return past.wroteStages && !sees(past, wanted);
}

static void advance(Past& past, const State& wanted)
{
    const bool write = wanted.access & kWriteAccess;
    if (write || past.layout != wanted.layout) {
        // A change of layout is a write of its own, which this access is the first to see.
        past.wroteStages = wanted.stages;
        past.wroteAccess = wanted.access & kWriteAccess;
        past.readStages = 0;
        past.seenStages = write ? 0 : wanted.stages;
        past.seenAccess = write ? 0 : wanted.access;
        past.layout = wanted.layout;
        return;
    }
    past.readStages |= wanted.stages;
    past.seenStages |= wanted.stages;
    past.seenAccess |= wanted.access;
}

// Barriers of a range: one when its parts share a past, otherwise one for each part that needs it.
static void moveRange(std::vector<Barrier>& barriers, std::uint32_t physical, Place& place, const ImageRange& range, const State& wanted)
{
    std::vector<Barrier> parts;
    for (std::uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip)
        for (std::uint32_t layer = range.layer; layer < range.layer + range.layers; ++layer) {
            Past& past = place.at(mip, layer);
            if (needsBarrier(past, wanted)) parts.push_back({physical, {mip, 1, layer, 1}, past.before(), wanted});
            advance(past, wanted);
        }
    const bool alike = std::all_of(parts.begin(), parts.end(), [&](const Barrier& part) { return part.before == parts[0].before; });
    if (!parts.empty() && alike && parts.size() == std::size_t(range.mips) * range.layers)
        barriers.push_back({physical, range, parts[0].before, wanted});
    else
        barriers.insert(barriers.end(), parts.begin(), parts.end());
}

// A place gets a new tenant: its texels are nobody's, but the work on them must still be over.
static void moveIn(Place& place, std::uint32_t resource, const Resource& tenant)
{
    if (place.resource == resource) return;
    const bool atRest = !tenant.isBuffer && tenant.origin != Origin::transient;
    place.resource = resource;
    for (Past& past : place.pasts) {
        past.layout = atRest ? kRestLayout : VK_IMAGE_LAYOUT_UNDEFINED;
        past.written = tenant.origin != Origin::transient;
    }
}

void deriveBarriers(const Graph& graph, Schedule& schedule)
{
    std::vector<Place> places(schedule.physicals.size());
    for (std::size_t p = 0; p < places.size(); ++p) {
        const Resource& resource = graph.resources[schedule.physicals[p].resource];
        if (!resource.isBuffer) places[p].mips = resource.shape.mips;
        if (!resource.isBuffer) places[p].layers = resource.shape.layers;
        places[p].pasts.resize(std::size_t(places[p].mips) * places[p].layers);
        moveIn(places[p], schedule.physicals[p].resource, resource);
    }
    for (ScheduledPass& scheduled : schedule.passes) {
        const PassData& pass = graph.passes[scheduled.pass];
        for (std::size_t a = 0; a < pass.accesses.size(); ++a) {
            const Access& access = pass.accesses[a];
            if (access.resource == kNoResource) continue;
            const Resource& resource = graph.resources[access.resource];
            const std::uint32_t physical = schedule.physicalOf[access.resource];
            Place& place = places[physical];
            moveIn(place, access.resource, resource);
            const ImageRange range = resource.isBuffer ? ImageRange{0, 1, 0, 1} : resolve(access.range, resource.shape);
            for (std::uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip)
                for (std::uint32_t layer = range.layer; layer < range.layer + range.layers; ++layer) {
                    bool& written = place.at(mip, layer).written;
                    check(written || !reads(access.use), "pass " + pass.name + " reads a part of " + resource.name + " that nothing wrote");
                    written = true;
                }
            // The first of several accesses to the same texels speaks for all of them.
            const bool spoken =
                std::any_of(pass.accesses.begin(), pass.accesses.begin() + static_cast<std::ptrdiff_t>(a),
                            [&](const Access& earlier) { return overlap(access, earlier) && earlier.range == access.range; });
            if (!spoken) moveRange(scheduled.barriers, physical, place, range, stateOf(pass, access));
        }
    }
    for (const Repeat& repeat : graph.repeats)
        for (const ScheduledPass& scheduled : schedule.passes)
            for (const Barrier& barrier : scheduled.barriers) {
                const bool repeated = scheduled.pass >= repeat.first && scheduled.pass < repeat.last;
                const bool isImage = !graph.resources[schedule.physicals[barrier.physical].resource].isBuffer;
                check(!repeated || !isImage || barrier.before.layout == barrier.after.layout,
                      "pass " + graph.passes[scheduled.pass].name + " is repeated, and would find an image in another layout");
            }
    // What outlives the frame returns to its rest, seen by whatever comes next.
    const State rest{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, kRestLayout};
    for (std::uint32_t p = 0; p < places.size(); ++p) {
        const Resource& resource = graph.resources[places[p].resource];
        if (resource.origin == Origin::transient && !resource.output) continue;
        State wanted = rest;
        if (resource.isBuffer) wanted.layout = VK_IMAGE_LAYOUT_UNDEFINED;
        moveRange(schedule.last, p, places[p], {0, places[p].mips, 0, places[p].layers}, wanted);
    }
}
}
