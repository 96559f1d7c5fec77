#include "baker/probe_search.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>

namespace afterglow
{
// Where in a cell's box: its middle, and between there and four of its corners.
static const dvec3 kTested[] = {{0.5, 0.5, 0.5}, {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
static constexpr std::size_t kTests = std::size(kTested);
static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// The light at positions[lights.size()...].
static void light(Search& search, const std::vector<dvec3>& positions, const ProbePaths& paths, std::vector<ProbeLight>& lights)
{
    BakeContext& context = search.context;
    const std::size_t first = lights.size(), count = positions.size() - first;
    lights.resize(positions.size());
    context.progress.expect(search.units + count);
    parallelFor(count, context.threads, [&](std::size_t i) {
        ProbeLight& out = lights[first + i];
        const std::uint32_t unit = search.units + std::uint32_t(i);
        doUnit(context, {Job::probes, unit}, {bytesOf(std::span(&out, 1))}, 1, [&](RayCount& rays) {
            out = probeLight(context, vec3(positions[first + i]), hash2(context.seed + 0x9e3779b9u, unit), paths, rays);
        });
        out.keep(search.effort.order); // of tests as well: more cells do not mend what an order cannot hold
    });
    search.units += std::uint32_t(count);
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
    light(search, search.corners.positions, {search.effort.samples, kMoreProbePaths * search.effort.samples, float(search.effort.noise)},
          search.lights);
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
        chamber.error2 += double(dot(off[0], off[1])) / kAll; // on average the noise of independent halves has no part in it
        chamber.light += double(dot(max(probeIrradiance(truth.probe(), axis), vec3(0.0f)), vec3(1.0f))) / kAll;
    }
}

void testCells(Search& search)
{
    std::vector<std::size_t> fresh;
    std::vector<dvec3> positions;
    for (std::size_t i = 0; i < search.chambers.size(); i++) {
        if (!search.alive(i) || search.chambers[i].tested) continue;
        const CellBox& box = search.chambers[i].box;
        fresh.push_back(i);
        for (dvec3 at : kTested)
            positions.push_back(
                freePoint(search.partition, search.partition.cells[i], mix(box.lower, box.upper, at), search.partition.thin));
    }
    std::vector<ProbeLight> truths;
    light(search, positions, {search.effort.samples, search.effort.samples}, truths);
    for (std::size_t c = 0; c < fresh.size(); c++) {
        Chamber& chamber = search.chambers[fresh[c]];
        chamber.tested = true;
        const ProbeCell cell = cellOf(chamber.box);
        for (std::size_t t = c * kTests; t < (c + 1) * kTests; t++) compare(search, cell, positions[t], truths[t], chamber);
        chamber.error2 = std::max(chamber.error2, 0.0);
    }
}
}
