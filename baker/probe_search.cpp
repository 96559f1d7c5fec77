#include "baker/probe_search.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <numeric>

namespace afterglow
{
// Where in a cell's box: its middle, and between there and four of its corners.
static const dvec3 kTested[kTests] = {{0.5, 0.5, 0.5}, {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

static constexpr uint kOfProbes = 0x9e3779b9u, kOfTests = 0x3c6ef372u; // seeds apart

// Units of work that are worth so many times the least paths of a probe each: unit(i, rays) fills result(i).
template <class Result, class Work>
static void doUnits(Search& search, const std::vector<std::uint64_t>& worth, const Result& result, const Work& unit)
{
    BakeContext& context = search.context;
    search.work = std::accumulate(worth.begin(), worth.end(), search.work);
    context.progress.expect(std::max(search.work, std::uint64_t(search.foretold)));
    parallelFor(worth.size(), context.threads, [&](std::size_t i) {
        doUnit(context, {Job::probes, search.units + std::uint32_t(i)}, {bytesOf(std::span(&result(i), 1))}, worth[i],
               [&](RayCount& rays) { unit(i, rays); });
    });
    search.units += std::uint32_t(worth.size());
}

void tracePaths(Search& search, const std::vector<int>& paths)
{
    std::vector<std::size_t> fewer;
    std::vector<std::uint64_t> worth;
    for (std::size_t i = 0; i < paths.size(); i++) {
        if (i == search.sums.size()) search.sums.push_back(noPaths(hash2(search.context.seed + kOfProbes, uint(i)), paths[i]));
        const int more = paths[i] - search.sums[i].paths();
        if (more > 0) fewer.push_back(i), worth.push_back(std::uint64_t(max(more / search.effort.samples, 1)));
    }
    const auto sumsOf = [&](std::size_t i) -> ProbeSums& { return search.sums[fewer[i]]; };
    doUnits(search, worth, sumsOf, [&](std::size_t i, RayCount& rays) {
        tracePaths(search.context, vec3(search.corners.positions[fewer[i]]), paths[fewer[i]], rays, sumsOf(i));
    });
    search.lights.resize(paths.size());
    parallelFor(fewer.size(), search.context.threads, [&](std::size_t i) {
        search.lights[fewer[i]] = lightOf(sumsOf(i));
        search.lights[fewer[i]].keep(search.effort.order);
    });
}

// The light at points, for a probe's least paths.
static std::vector<ProbeLight> lightAt(Search& search, const std::vector<dvec3>& positions)
{
    std::vector<ProbeLight> lights(positions.size());
    const std::uint32_t first = search.units;
    const int samples = search.effort.samples;
    doUnits(
        search, std::vector<std::uint64_t>(positions.size(), 1), [&](std::size_t i) -> ProbeLight& { return lights[i]; },
        [&](std::size_t i, RayCount& rays) {
            ProbeSums sums = noPaths(hash2(search.context.seed + kOfTests, first + uint(i)), samples);
            tracePaths(search.context, vec3(positions[i]), samples, rays, sums);
            lights[i] = lightOf(sums);
            lights[i].keep(search.effort.order); // more cells do not mend what an order cannot hold
        });
    return lights;
}

ProbeCell cellOf(const CellBox& box)
{
    ProbeCell cell;
    cell.lower = vec3(box.lower);
    for (int axis = 0; axis < 3; axis++) {
        const double extent = box.upper[axis] - box.lower[axis];
        cell.perExtent[axis] = extent > 0.0 ? float(1.0 / extent) : 0.0f;
    }
    std::copy(box.probe.begin(), box.probe.end(), cell.probe);
    return cell;
}

void placeProbes(Search& search)
{
    search.chambers.resize(search.partition.cells.size());
    for (std::size_t i = 0; i < search.chambers.size(); i++) {
        Chamber& chamber = search.chambers[i];
        if (chamber.placed || !search.alive(i)) continue;
        stopIfInterrupted();
        const Partition::Cell& cell = search.partition.cells[i];
        chamber.box = placeCorners(search.partition, cell, search.corners);
        chamber.volume = cell.region.volume();
        chamber.placed = true;
    }
    tracePaths(search, std::vector<int>(search.corners.positions.size(), search.effort.samples));
}

// What a half of the paths says about an axis.
static vec3 halfAbout(const ProbeLight& light, int half, vec3 axis)
{
    return probeIrradiance({light.half[half], light.lobe, light.toward}, axis);
}

static void compare(const Search& search, const ProbeCell& cell, dvec3 position, const ProbeLight& truth, Chamber& chamber)
{
    const vec3 fraction = probeFraction(cell, vec3(position));
    for (vec3 axis : kAxes) {
        vec3 off[2];
        for (int half = 0; half < 2; half++) {
            off[half] = -halfAbout(truth, half, axis);
            for (int corner = 0; corner < 8; corner++)
                off[half] += probeTrilinear(fraction, corner) * halfAbout(search.lights[cell.probe[corner]], half, axis);
        }
        constexpr double kAll = double(3 * std::size(kAxes) * kTests);
        chamber.error2 += double(dot(off[0], off[1])) / kAll; // on average the bands' noise has no part in it: halves are independent
        chamber.light += double(dot(max(probeIrradiance(truth.probe(), axis), vec3(0.0f)), vec3(1.0f))) / kAll;
    }
}

void testCells(Search& search, std::size_t ofEach)
{
    std::vector<std::size_t> fresh;
    std::vector<dvec3> positions;
    for (std::size_t i = 0; i < search.chambers.size(); i++) {
        if (!search.alive(i) || search.chambers[i].tested || i % ofEach != 0) continue;
        stopIfInterrupted();
        const CellBox& box = search.chambers[i].box;
        fresh.push_back(i);
        for (dvec3 at : kTested)
            positions.push_back(
                freePoint(search.partition, search.partition.cells[i], mix(box.lower, box.upper, at), search.partition.thin));
    }
    const std::vector<ProbeLight> truths = lightAt(search, positions);
    for (std::size_t c = 0; c < fresh.size(); c++) {
        Chamber& chamber = search.chambers[fresh[c]];
        chamber.tested = true;
        const ProbeCell cell = cellOf(chamber.box);
        for (std::size_t t = c * kTests; t < (c + 1) * kTests; t++) compare(search, cell, positions[t], truths[t], chamber);
        chamber.error2 = std::max(chamber.error2, 0.0);
    }
}
}
