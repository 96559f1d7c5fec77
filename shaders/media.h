// The media of a level along a ray: where each lies, what they leave of light, and what they send out by themselves.
// The includer defines, before this line:
//   struct Air                                        what the functions below need, passed by value
//   uint   mediumCount(Air);  Medium mediumAt(Air, uint)
//   vec4   mediumPlaneAt(Air, uint)                   of all media's, Medium::firstPlane on
#ifndef AFTERGLOW_MEDIA_H
#define AFTERGLOW_MEDIA_H
#include "shaders/color.h"
#include "shaders/medium.h"
SHARED_BEGIN

// Where the ray runs inside the medium.
FN Span mediumSpan(Air air, Medium m, vec3 o, vec3 d, float limit)
{
    Span s = boxSpan(o, d, m.lower, m.upper, limit);
    for (uint i = 0u; i < m.planeCount && s.end > s.begin; i++) s = planeSpan(s, o, d, mediumPlaneAt(air, m.firstPlane + i));
    return s;
}

// Optical depth of a stretch that may be infinitely long; a void has none.
FN float opticalDepth(float sigmaT, float distance_) { return sigmaT > 0.0f ? sigmaT * distance_ : 0.0f; }
FN vec3 opticalDepth(vec3 sigmaT, float distance_)
{
    return vec3(opticalDepth(sigmaT.x, distance_), opticalDepth(sigmaT.y, distance_), opticalDepth(sigmaT.z, distance_));
}

FN vec3 mediaDepth(Air air, vec3 o, vec3 d, float limit)
{
    vec3 depth = vec3(0.0f);
    for (uint i = 0u; i < mediumCount(air); i++) {
        Medium m = mediumAt(air, i);
        depth += opticalDepth(extinctionOf(m), spanLength(mediumSpan(air, m, o, d, limit)));
    }
    return depth;
}
FN vec3 mediaTransmittance(Air air, vec3 o, vec3 d, float limit) { return exp(-mediaDepth(air, o, d, limit)); }

// The stretch of a ray from `position` to the next border of a medium: what fills it.
struct Stretch {
    float end; // m along the ray
    vec3 scattering;
    vec3 extinction;
    vec3 emission;
    float cosine; // sum of g by each medium's scattering, luminance
};
FN Stretch stretchFrom(Air air, vec3 o, vec3 d, float limit, float position)
{
    Stretch s = Stretch(limit, vec3(0.0f), vec3(0.0f), vec3(0.0f), 0.0f);
    for (uint i = 0u; i < mediumCount(air); i++) {
        Medium m = mediumAt(air, i);
        Span inside = mediumSpan(air, m, o, d, limit);
        if (!(inside.end > inside.begin)) continue;
        if (inside.begin > position)
            s.end = min(s.end, inside.begin);
        else if (inside.end > position) {
            s.end = min(s.end, inside.end);
            s.scattering += m.scattering;
            s.extinction += extinctionOf(m);
            s.emission += m.emission;
            s.cosine += m.g * luminance(m.scattering);
        }
    }
    return s;
}

// Radiance that the media send toward the ray's origin by themselves, dimmed on its way: exact.
FN vec3 mediaEmission(Air air, vec3 o, vec3 d, float limit)
{
    vec3 sum = vec3(0.0f), through = vec3(1.0f);
    float position = 0.0f;
    while (position < limit) {
        Stretch s = stretchFrom(air, o, d, limit, position);
        float length_ = s.end - position;
        sum += through * stepInscatter(s.emission, s.extinction, length_);
        through *= transmittance(s.extinction, length_);
        position = s.end;
    }
    return sum;
}

SHARED_END
#endif
