#include "baker/seam_patches.hpp"
#include "baker/sets.hpp"

namespace afterglow
{
static constexpr uint kNone = ~0u;

// Texels that one point touches are of one set. Whatever has no weight in a lookup has no part in it.
static Sets joined(const Seams& seams)
{
    Sets sets(seams.texels.size());
    for (const SeamPoint& point : seams.points) {
        uint first = kNone;
        for (const Lookup& side : point.side)
            for (const Weighted& w : footprint(seams, side)) {
                if (!(w.weight > 0.0f)) continue;
                if (first == kNone) first = uint(w.texel);
                sets.join(first, uint(w.texel));
            }
    }
    return sets;
}

// The lookup with its texels counted within their patch; those without weight stand for any.
static std::array<Weighted, 4> within(const std::vector<uint>& column, std::array<Weighted, 4> touched)
{
    for (Weighted& w : touched) w.texel = w.weight > 0.0f ? column[w.texel] : 0;
    return touched;
}

std::vector<SeamPatch> seamPatches(const Seams& seams)
{
    Sets sets = joined(seams);
    std::vector<SeamPatch> patches;
    std::vector<uint> patchOf(seams.texels.size(), kNone); // by the set's root
    const auto rootOf = [&](const SeamPoint& point) {
        for (const Weighted& w : footprint(seams, point.side[0]))
            if (w.weight > 0.0f) return sets.root(uint(w.texel));
        return kNone; // weights add up to 1
    };
    for (uint p = 0; p < seams.points.size(); p++) {
        uint& patch = patchOf[rootOf(seams.points[p])];
        if (patch == kNone) patch = uint(patches.size()), patches.emplace_back();
        patches[patch].points.push_back(p);
    }
    std::vector<uint> column(seams.texels.size(), 0);
    for (uint t = 0; t < seams.texels.size(); t++) {
        const uint patch = patchOf[sets.root(t)];
        if (patch == kNone) continue;
        column[t] = uint(patches[patch].texels.size());
        patches[patch].texels.push_back(t);
    }
    for (SeamPatch& patch : patches)
        for (int s = 0; s < 2; s++)
            for (uint p : patch.points) patch.side[s].push_back(within(column, footprint(seams, seams.points[p].side[s])));
    return patches;
}
}
