// Irradiance probes: a box of them, SH order 2 of irradiance / pi (shaders/lightmap.h says what that is) at the corners of its cells.
// Probe (i, j, k) stands at (i, j, k) / (n - 1) of the unit box, in its middle on an axis with n = 1. Order: x fastest, then y, then z.
#ifndef AFTERGLOW_PROBE_H
#define AFTERGLOW_PROBE_H
#include "shaders/constants.h"
SHARED_BEGIN

// Position of a probe in the box [-1/2, 1/2]^3.
FN float probeUnitPosition(int i, int n) { return n > 1 ? float(i) / float(n - 1) - 0.5f : 0.0f; }
FN vec3 probeUnitPosition(ivec3 i, ivec3 n)
{
    return vec3(probeUnitPosition(i.x, n.x), probeUnitPosition(i.y, n.y), probeUnitPosition(i.z, n.z));
}
FN int probeIndex(ivec3 i, ivec3 n) { return i.x + n.x * (i.y + n.y * i.z); }

// The cell around a point of the box, and the eight weights of its corners.
struct ProbeCell {
    ivec3 lower;   // the corner with the smallest coordinates
    vec3 fraction; // 0..1 within the cell
};

// Outside the box the point is clamped to its border; an axis with n = 1 is constant.
FN ProbeCell probeCell(vec3 unitPosition, ivec3 n)
{
    ProbeCell cell;
    for (int a = 0; a < 3; ++a) {
        float last = float(max(n[a] - 1, 0));
        float x = clamp(unitPosition[a] + 0.5f, 0.0f, 1.0f) * last;
        if (!(x >= 0.0f)) x = 0.0f;
        int i = min(int(x), max(n[a] - 2, 0));
        cell.lower[a] = i;
        cell.fraction[a] = x - float(i);
    }
    return cell;
}

// Corner 0..7: bit 0 = +x, bit 1 = +y, bit 2 = +z; clamped, so that a flat axis meets the same probe twice.
FN ivec3 probeCorner(ProbeCell cell, int corner, ivec3 n)
{
    ivec3 i = cell.lower + ivec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    return ivec3(min(i.x, n.x - 1), min(i.y, n.y - 1), min(i.z, n.z - 1));
}
FN float probeTrilinear(ProbeCell cell, int corner)
{
    float x = (corner & 1) != 0 ? cell.fraction.x : 1.0f - cell.fraction.x;
    float y = (corner & 2) != 0 ? cell.fraction.y : 1.0f - cell.fraction.y;
    float z = (corner & 4) != 0 ? cell.fraction.z : 1.0f - cell.fraction.z;
    return x * y * z;
}

// The validity of a probe: 1 where it was measured; 0 where it stands inside a solid and nothing is known; between them where it borrowed
// the mean of its neighbours. So little that it has a say only where every measured probe is out of reach: at equal distance it changes
// an answer by 1/8192 (exact in half floats), times 21 when it alone lies before the surface.
const float kProbeBorrowed = 1.0f / 8192.0f;
FN bool probeTrusted(float validity) { return validity > kProbeBorrowed; }

// Weight of a probe for a surface: its trilinear share, its validity, and whether it lies before the surface: a probe behind the surface sees
// other light. Smooth to 0 at 90 degrees behind; never quite 0 for a valid probe, so that a surface whose eight corners all lie behind it
// still gets their mean. Divide the weighted sum by the sum of the weights; when that is 0, none of the eight knows anything.
FN float probeWeight(float trilinear, float validity, vec3 toProbe, vec3 normal)
{
    float d = length(toProbe);
    float facing = d > 0.0f ? dot(toProbe, normal) / d : 1.0f;
    float front = 0.5f * facing + 0.5f;
    return trilinear * validity * (front * front + 0.05f); // 0.05: DDGI's floor (Majercik et al. 2019)
}

// Share of a box at a point of its unit space: 1 inside, 0 outside, and a short ramp between beyond its walls.
FN float boxShare(vec3 unitPosition, vec3 ramp)
{
    vec3 inside = clamp((0.5f + ramp - abs(unitPosition)) / ramp, 0.0f, 1.0f);
    return inside.x * inside.y * inside.z;
}

// Visibility from the first two moments of distance (Chebyshev): 1 up to the mean, then var / (var + (d - mean)^2).
FN float chebyshevVisibility(float mean, float variance, float distance_)
{
    if (distance_ <= mean) return 1.0f;
    float v = max(variance, 0.0f);
    float beyond = distance_ - mean;
    return v / (v + beyond * beyond);
}

SHARED_END
#endif
