#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/memory.hpp"
#include "baker/probe_noise.hpp"
#include "baker/probes.hpp"
#include "engine/core/error.hpp"
#include "engine/core/log.hpp"
#include "engine/core/machine.hpp"
#include "engine/scene/scene.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace afterglow
{
static constexpr double kFinest = 0.125; // of the spacing: cells are cut so small for what stands in them
static constexpr double kInset = 0.1;    // of the finest: probes stand so far from walls
static constexpr double kThin = 0.02;    // of the finest
static constexpr int kRounds = 16;
static constexpr std::size_t kMostCells = 200000;
static constexpr std::uint64_t kCellHeld = 8500; // bytes of a cell with its probes and tests, while they are made: 6 to 8 KB measured
static constexpr double kGained = 0.65;          // of a cell's error by cutting it: three quarters where light is smooth
static constexpr double kPerRound = 0.75;        // of the error that a round may leave, foretold: what it cuts is then measured anew
static constexpr std::size_t kSampled = 8;       // of the first cells one of so many tells how many more there will be
static constexpr double kUnseen = 14.0;          // work of each of the first cells, until their light is looked at: 7 to 130 in six levels
static constexpr std::uint64_t kCellBytes = 64, kNodeBytes = 32;

static std::uint64_t probeBytes(int order) { return order < 2 ? 33 : 73; }
static std::uint64_t cutBytes(int order) { return 19 * probeBytes(order) + 8 * kCellBytes + 7 * kNodeBytes; }

std::uint64_t bytesOf(const ProbeTree& tree)
{
    return tree.probes.size() * probeBytes(tree.order) + tree.cells.size() * kCellBytes + tree.nodes.size() * kNodeBytes;
}

// What a cell adds to the relative error, times its volume.
static double offOf(const Chamber& chamber, double mean)
{
    return chamber.light > 0.0 ? chamber.volume * std::sqrt(chamber.error2) / (chamber.light + kDark * mean) : 0.0;
}

namespace
{
// Volume of space that was tested, mean light in it, and the relative error.
struct State {
    double volume = 0.0, mean = 0.0, off = 0.0;
};
}

static State stateOf(const Search& search)
{
    State state;
    for (std::size_t i = 0; i < search.chambers.size(); i++)
        if (search.alive(i) && search.chambers[i].tested)
            state.volume += search.chambers[i].volume, state.mean += search.chambers[i].volume * search.chambers[i].light;
    if (!(state.volume > 0.0)) return state;
    state.mean /= state.volume;
    for (std::size_t i = 0; i < search.chambers.size(); i++)
        if (search.alive(i)) state.off += offOf(search.chambers[i], state.mean) / state.volume;
    return state;
}

// Throws Error when the cells there are take more memory than the bake may hold; `before`: bytes of the process without them.
static void demandRoom(const Search& search, std::uint64_t before)
{
    const std::uint64_t cells = search.partition.cells.size(), needed = before + cells * kCellHeld;
    if (search.effort.memory && needed > *search.effort.memory)
        throw Error(fmt::format("--max-memory {}M does not hold the irradiance probes of this bake: their {} cells need {}M{}",
                                *search.effort.memory >> 20, cells, ((needed + kUneven) >> 20) + 1,
                                search.effort.error > 0.0 ? " and are cut further where light changes; give more, or a larger --probe-error"
                                                          : "; give that, or let probes stand farther apart"),
                    Exit::usage);
}

// What all will take, as the cells and paths of now err.
static void foretell(Search& search)
{
    std::size_t untested = 0;
    for (std::size_t i = 0; i < search.chambers.size(); i++) untested += search.alive(i) && !search.chambers[i].tested ? 1 : 0;
    const double cuts = std::max(std::pow(stateOf(search).off / search.effort.error, kCuts), 1.0);
    search.foretold = double(search.work + untested * kTests) * cuts + noiseWork(search) * std::sqrt(cuts); // many small cells share probes
}

// Cuts the cells where most is to be gained; false: all is good enough, or as large as it may be.
static bool cutWorst(Search& search)
{
    const State state = stateOf(search);
    if (!(state.volume > 0.0)) return false;
    std::vector<std::size_t> worst;
    std::uint64_t bytes = search.lights.size() * probeBytes(search.effort.order);
    for (std::size_t i = 0; i < search.chambers.size(); i++)
        if (search.alive(i)) worst.push_back(i), bytes += kCellBytes + kNodeBytes;
    const auto off = [&](std::size_t cell) { return offOf(search.chambers[cell], state.mean) / state.volume; };
    std::stable_sort(worst.begin(), worst.end(), [&](std::size_t a, std::size_t b) { return off(a) > off(b); });
    const std::uint64_t more = cutBytes(search.effort.order);
    double left = state.off;
    bool cut = false;
    for (std::size_t i : worst) {
        if (!(left > std::max(search.effort.error, kPerRound * state.off)) || bytes + more > search.effort.bytes) break;
        left -= kGained * off(i);
        bytes += more;
        cutCell(search.partition, i);
        cut = true;
    }
    return cut;
}

// The tree as it is read: what was cut is left out, and the probes that only it had.
static int copyTree(const Search& search, int child, std::vector<uint>& number, ProbesResult& result)
{
    ProbeTree& tree = result.tree;
    while (child < 0 && !search.alive(std::size_t(~child))) child = search.partition.cells[std::size_t(~child)].instead;
    if (child >= 0) {
        const std::size_t place = tree.nodes.size();
        tree.nodes.push_back(search.partition.nodes[std::size_t(child)]);
        const int below = copyTree(search, tree.nodes[place].below, number, result),
                  above = copyTree(search, tree.nodes[place].above, number, result);
        tree.nodes[place].below = below, tree.nodes[place].above = above;
        return int(place);
    }
    ProbeCell cell = cellOf(search.chambers[std::size_t(~child)].box);
    for (uint& probe : cell.probe) {
        if (number[probe] == ~0u) {
            number[probe] = uint(tree.probes.size());
            tree.probes.push_back(search.lights[probe].probe());
            tree.positions.push_back(vec3(search.corners.positions[probe]));
            tree.stands.push_back(search.corners.stands[probe]);
            result.samples += search.sums[probe].paths();
        }
        probe = number[probe];
    }
    tree.cells.push_back(cell);
    return ~int(tree.cells.size() - 1);
}

static std::vector<vec3> lampsOf(const std::vector<Light>& lights)
{
    std::vector<vec3> lamps;
    for (const Light& light : lights)
        if (light.type != kLightDirectional && isDeltaLight(light)) lamps.push_back(light.position);
    return lamps;
}

namespace
{
// Boxes that were placed by hand, as bounds.
struct Placed {
    dvec3 lower, upper;
    double spacing;
};
}

static std::vector<Placed> placedIn(const Scene& scene)
{
    std::vector<Placed> all;
    for (const ProbeVolumeRequest& asked : scene.probeVolumes) {
        const dvec3 middle(asked.toWorld[3]),
            reach = 0.5 * (abs(dvec3(asked.toWorld[0])) + abs(dvec3(asked.toWorld[1])) + abs(dvec3(asked.toWorld[2])));
        all.push_back({middle - reach, middle + reach, double(asked.spacing)});
    }
    return all;
}

double cellsIn(dvec3 extent, double spacing)
{
    const dvec3 along = max(extent / spacing, dvec3(1.0));
    return along.x * along.y * along.z;
}

double spacingWithin(dvec3 extent, double wanted, double cells)
{
    double spacing = wanted > 0.0 ? wanted : 1e-3 * std::max({extent.x, extent.y, extent.z});
    while (spacing > 0.0 && std::isfinite(spacing) && !(cellsIn(extent, spacing) <= cells)) spacing *= 1.1;
    return spacing;
}

// Of a box, and what is left about it, that is halved until its cells are no larger.
static double halvedCells(dvec3 extent, double spacing)
{
    const dvec3 halvings = ceil(log2(max(extent / spacing, dvec3(1.0)) + 4.0 * kThin * kFinest));
    return std::exp2(halvings.x + halvings.y + halvings.z);
}

// What was asked for, or the least that fits; then a line says so.
static double spacingFor(dvec3 extent, double wanted)
{
    double spacing = spacingWithin(extent, wanted, double(kMostCells));
    while (spacing > 0.0 && std::isfinite(spacing) && halvedCells(extent, spacing) > double(kMostCells)) spacing *= 1.1;
    if (spacing > wanted)
        note(fmt::format("irradiance probes stand {:.3g} m apart, not {:.3g}: more cells than {} would take too much memory", spacing,
                         wanted, kMostCells));
    return spacing;
}

ProbesResult bakeProbes(BakeContext& context, const ProbeEffort& effort)
{
    const World& world = context.transport.world;
    dvec3 lower(world.scene().lower), upper(world.scene().upper);
    std::vector<Placed> placed = placedIn(world.scene());
    const double wide = placed.empty() ? spacingFor(upper - lower, effort.spacing)
                                       : spacingWithin(upper - lower, effort.spacing, double(kMostCells)); // of cells about them: a bound
    double least = placed.empty() ? wide : std::numeric_limits<double>::infinity();
    for (Placed& box : placed) {
        box.spacing = spacingFor(box.upper - box.lower, box.spacing);
        least = std::min(least, box.spacing), lower = min(lower, box.lower), upper = max(upper, box.upper);
    }
    const dvec3 flat = max(dvec3(0.5 * least) - 0.5 * (upper - lower), dvec3(0.0)); // above and below a mere floor, too
    lower -= flat, upper += flat;
    const double thin = kThin * kFinest * least;
    ProbesResult result;
    result.tree.order = effort.order;
    if (!(thin > 0.0 && std::isfinite(thin) && std::isfinite(length(upper - lower)))) return result;

    // The smallest of the boxes that a region reaches into; outside of them all, `otherwise`
    const auto smallest = [&](dvec3 from, dvec3 to, double otherwise) {
        double wanted = std::numeric_limits<double>::infinity();
        for (const Placed& box : placed)
            if (all(lessThan(max(from, box.lower), min(to, box.upper)))) wanted = std::min(wanted, box.spacing);
        return std::isfinite(wanted) ? wanted : otherwise;
    };
    const Spacing spacing = [&](dvec3 from, dvec3 to) {
        return placed.empty() ? wide : smallest(from, to, std::numeric_limits<double>::infinity());
    };
    const Spacing finest = [&](dvec3 from, dvec3 to) { return kFinest * smallest(from, to, wide); };
    Search search{.context = context,
                  .effort = effort,
                  .partition = {.world = world,
                                .solids = context.solids,
                                .lower = lower,
                                .upper = upper,
                                .walls = effort.walls,
                                .finest = finest,
                                .most = kMostCells,
                                .thin = thin,
                                .lamps = lampsOf(context.direct)},
                  .corners = {.inset = kInset * kFinest * least}};
    std::vector<uint> triangles(world.triangles().size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    context.progress.begin("probes", 0, "batches");
    const std::uint64_t before = memoryNow();
    const int root = part(search.partition, boxRegion(lower - 2.0 * thin, upper + 2.0 * thin), triangles, spacing);
    if (root != kNowhere) {
        demandRoom(search, before);
        if (effort.error > 0.0) search.foretold = kUnseen * double(search.partition.cells.size());
        placeProbes(search);
        for (int round = 0; round < kRounds && effort.error > 0.0; round++) {
            if (round == 0) testCells(search, kSampled), foretell(search);
            testCells(search);
            foretell(search);
            if (!cutWorst(search)) break;
            demandRoom(search, before);
            placeProbes(search);
        }
        if (effort.error > 0.0) testCells(search);
        lessenNoise(search);
        context.progress.expect(search.work); // all there was
        std::vector<uint> number(search.lights.size(), ~0u);
        const int top = copyTree(search, root, number, result);
        if (top < 0) result.tree.nodes.push_back({vec3(0.0f), 0.0f, top, top}); // all of space is one cell
        result.estimatedError = float(lookupNoise(search));
        result.samples /= double(result.tree.probes.size());
        result.interpolationError = float(stateOf(search).off);
    }
    context.progress.end();
    return result;
}
}
