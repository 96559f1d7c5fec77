// Many paths at once, stage by stage: the closest hits of all of them, then a step of each (advance of shaders/transport.h), then the
// shadow rays that those steps sent, in packets; and again with the paths that go on. The estimator and its random numbers are those of
// radianceAlong(), which takes one path after the other: each path's radiance is the same, up to the order in which it is summed.
#pragma once
#include "baker/tracer.hpp"
#include <vector>

namespace afterglow
{
// A set of paths, and what its stages hand on to each other. Kept by a thread, so that it allocates once.
struct Wave {
    std::vector<Path> paths;
    std::vector<Hit> hits;    // of their rays; negative distance: still to be asked for
    std::vector<uint> living; // paths that go on
    ShadowRays shadows;       // sent and not yet asked for

    void begin()
    {
        paths.clear();
        hits.clear();
        living.clear();
    }
    void add(const Path& path, const Hit& hit)
    {
        living.push_back(uint(paths.size()));
        paths.push_back(path);
        hits.push_back(hit);
    }
};

// Follows all of wave.living to their ends: then paths[i].radiance is whole. Paths that were added one after the other should begin close
// together and point alike. `first`: see advance().
void followAll(Tracer first, Tracer tracer, Wave& wave);
}
