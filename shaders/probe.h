// Irradiance probes: points of free space with the light that meets them from everywhere, and a tree of planes that says which of them a
// point asks. The planes are walls, so that no cell reaches through one, and cuts where light changes fast. A cell is convex and asks eight
// probes that it sees, near the corners of a box. What it needs of visibility is settled when the tree is made: a lookup tests none. Things
// that hide less than three fifths of a cell from itself, or are smaller than an eighth of the spacing, are no walls.
#ifndef AFTERGLOW_PROBE_H
#define AFTERGLOW_PROBE_H
#include "shaders/sh.h"
SHARED_BEGIN

// Irradiance / pi about a normal: three bands, and one lobe for what they cannot hold of a compact light. Without it they ring to 3/32 of
// that light from the side, and below 0.
struct Probe {
    Sh9 irradiance; // convolved with the cosine
    vec3 lobe;      // of one clamped cosine, its bands above the second
    vec3 toward;    // that cosine's axis, unit length; 0: there is none
};

// A plane that parts space; a child is a node, or ~cell.
struct ProbeNode {
    vec3 normal;
    float offset; // m: the child `above` holds the points with dot(normal, position) > offset
    int below;
    int above;
};

struct ProbeCell {
    vec3 lower;     // m, of the box that its probes stand at the corners of
    vec3 perExtent; // 1 / m; 0 on an axis that is flat
    uint probe[8];  // bit 0 of the corner = +x, bit 1 = +y, bit 2 = +z
};

// max(cos, 0) less its bands 0 to 2.
FN float cosineRemainder(float cosine) { return max(cosine, 0.0f) - (0.09375f + 0.5f * cosine + 0.46875f * cosine * cosine); }

// A sum of weighted probes about `normal`; may ring below 0 until all are summed.
FN vec3 probeIrradiance(IN(Probe) probe, vec3 normal)
{
    return shEvaluate(probe.irradiance, normal) + probe.lobe * cosineRemainder(dot(probe.toward, normal));
}

// Where a point lies between a cell's corners, 0..1 an axis; outside of the box: on its border.
FN vec3 probeFraction(IN(ProbeCell) cell, vec3 position)
{
    vec3 x = (position - cell.lower) * cell.perExtent;
    // No NaN gets past these comparisons
    return vec3(x.x > 0.0f ? min(x.x, 1.0f) : 0.0f, x.y > 0.0f ? min(x.y, 1.0f) : 0.0f, x.z > 0.0f ? min(x.z, 1.0f) : 0.0f);
}
FN float probeTrilinear(vec3 fraction, int corner)
{
    float x = (corner & 1) != 0 ? fraction.x : 1.0f - fraction.x;
    float y = (corner & 2) != 0 ? fraction.y : 1.0f - fraction.y;
    float z = (corner & 4) != 0 ? fraction.z : 1.0f - fraction.z;
    return x * y * z;
}

SHARED_END
#endif
