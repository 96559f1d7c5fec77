// Bloom: light that a lens scatters. Down to ever coarser pictures and up again, each step a matrix that neither makes nor loses light.
// Along an axis of n pixels halved to m = ceil(n / 2), both rows of pixels cover the same length; a fine pixel shares its light by overlap,
// after the tent (1 2 1) / 4 has spread it. For even n that is (1 3 3 1) / 8 on the way down and linear interpolation on the way up; for
// odd n the weights differ from pixel to pixel, and their sums still are 1 in rows and columns: even light stays even, and all of it stays.
#ifndef AFTERGLOW_BLOOM_H
#define AFTERGLOW_BLOOM_H
#include "shaders/color.h"
SHARED_BEGIN

struct BloomParameters {
    float strength; // share of all light that is scattered, 0..1 (ag_bloom)
    float spread;   // share of what is scattered at one level that goes on to the next coarser one, 0..1
    uint coarsest;  // px: halved until the longer edge has no more; the glare reaches about 1 / coarsest of the picture
};
FN BloomParameters defaultBloomParameters()
{
    BloomParameters p;
    p.strength = 0.0f;
    p.spread = 0.7f;
    p.coarsest = 16u;
    return p;
}

struct BloomPush {
    float share; // of the light that comes from the coarser level; unused on the way down
};

// Specialization constants: the axes are halved evenly (else by ceil), and the texels read are the picture's own, not yet limited.
const uint kBloomUneven = 0u;
const uint kBloomFirst = 1u;

// What may be spread: one infinite pixel would fill the picture, one that is not a number would blacken it.
FN vec3 bloomInput(vec3 radiance) { return vec3(displayInput(radiance.x), displayInput(radiance.y), displayInput(radiance.z)); }

// Length common to the fine pixel (of n) and the coarse pixel (of m), in units of 1 / (n m) of the axis.
FN int bloomOverlap(int fine, int coarse, int n, int m)
{
    return max(0, min((fine + 1) * m, (coarse + 1) * n) - max(fine * m, coarse * n));
}

// The same with the tent on the fine side, its ends folded back at the borders. Over n: the weight of `fine` in `coarse` on the way down;
// over m: of `coarse` in `fine` on the way up. 0 for a coarse pixel outside.
FN float bloomShare(int fine, int coarse, int n, int m)
{
    int sum = bloomOverlap(max(fine - 1, 0), coarse, n, m) + 2 * bloomOverlap(fine, coarse, n, m) +
              bloomOverlap(min(fine + 1, n - 1), coarse, n, m);
    return 0.25f * float(sum);
}

// First pixels that may have a share: of 4 (5 where the axis is uneven) on the way down, of 2 (3) on the way up; they may lie outside.
FN int bloomFirstFine(int coarse, int n, int m) { return coarse * n / m - 1; }
FN int bloomFirstCoarse(int fine, int n, int m) { return (fine * m + n - m) / n - 1; } // floor((fine - 1) m / n)

SHARED_END
#endif
