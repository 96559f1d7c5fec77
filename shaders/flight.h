// How light and paths travel through the media of a level: what a segment lets pass, and where on it a path collides.
// Needs of its includer mediumCount and mediumAt (shaders/transport.h).
#ifndef AFTERGLOW_FLIGHT_H
#define AFTERGLOW_FLIGHT_H
#include "shaders/color.h"
#include "shaders/medium.h"
#include "shaders/path.h"
#include "shaders/random.h"
#include "shaders/ray.h"
#include "shaders/scene.h"
SHARED_BEGIN

// What the level's media leave of light along a segment.
FN vec3 mediaTransmittance(Tracer tracer, Ray ray)
{
    vec3 through = vec3(1.0f);
    for (uint i = 0u; i < mediumCount(tracer); i++) through *= transmittance(mediumAt(tracer, i), ray.origin, ray.direction, ray.far);
    return through;
}

// Free flight along `ray`: where the next collision with a medium lies (distance >= ray.far: none), the weight of the path that goes on,
// and the mean cosine there. Distances are drawn for the mean extinction of the three channels and weighted by each (chromatic media stay
// unbiased: pdf = average over channels).
struct Flight {
    float distance;
    vec3 weight;
    float g;
    uint scattered;
};
FN Flight flyThroughMedia(Tracer tracer, Ray ray, INOUT(Sampler) random)
{
    Flight flight = Flight(ray.far, vec3(1.0f), 0.0f, 0u);
    if (mediumCount(tracer) == 0u) return flight;
    float position = 0.0f;
    float channel = next1(random);
    float remaining = -log(1.0f - next1(random)); // optical depth until the collision, in the drawn channel
    vec3 depth = vec3(0.0f);
    while (position < ray.far) {
        // The media that cover the stretch up to the next border, and that border.
        float border = ray.far;
        vec3 scattering = vec3(0.0f);
        vec3 extinction = vec3(0.0f);
        float cosine = 0.0f;
        for (uint i = 0u; i < mediumCount(tracer); i++) {
            Medium medium = mediumAt(tracer, i);
            Span inside = boxSpan(ray.origin, ray.direction, medium.lower, medium.upper, ray.far);
            if (inside.begin > position)
                border = min(border, inside.begin);
            else if (inside.end > position) {
                border = min(border, inside.end);
                scattering += medium.scattering;
                extinction += extinctionOf(medium);
                cosine += medium.g * luminance(medium.scattering);
            }
        }
        float drawn = channel < 1.0f / 3.0f ? extinction.x : channel < 2.0f / 3.0f ? extinction.y : extinction.z;
        float step = border - position;
        if (drawn * step > remaining) {
            step = remaining / drawn;
            depth += extinction * step;
            vec3 passed = exp(-depth);
            float pdf = dot(extinction * passed, vec3(1.0f / 3.0f));
            flight.distance = position + step;
            flight.weight = pdf > 0.0f ? scattering * passed / pdf : vec3(0.0f);
            float total = luminance(scattering);
            flight.g = total > 0.0f ? cosine / total : 0.0f;
            flight.scattered = 1u;
            return flight;
        }
        remaining -= drawn * step;
        depth += extinction * step;
        position = border;
    }
    vec3 passed = exp(-depth);
    float pdf = dot(passed, vec3(1.0f / 3.0f));
    flight.weight = pdf > 0.0f ? passed / pdf : vec3(0.0f);
    return flight;
}

SHARED_END
#endif
