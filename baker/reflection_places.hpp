// Where reflection probes stand: where glossy surfaces look, so that what these mirror is in sight, and little beside itself.
#pragma once
#include "baker/context.hpp"
#include "engine/baked/baked.hpp"

namespace afterglow
{
struct PlacedReflections {
    std::vector<ReflectionProbe> probes;         // not lit yet
    std::vector<std::optional<float>> boxErrors; // of each: mean angle by which what it covers and sees is looked up beside itself, radians
    std::optional<float> error;                  // of all together (reflection_box.hpp): 0 right, kUncovered without a probe, 1 quite wrong
    // An error is absent where nothing glossy tells it.
};

// The probes that the level asks for, with its boxes; otherwise up to `most`, as many as the level's glossy surfaces (isGlossy) gain by:
// none where there are none. Each stands in the open, on the way of something mirrored. The same whatever the seed or the thread count.
PlacedReflections placeReflections(const BakeContext& context, int most);
}
