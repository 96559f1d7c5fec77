// How light and paths travel through the media of a level: what a segment lets pass, and where on it a path collides.
// Needs of its includer what shaders/media.h asks for, and airOf(Tracer) (shaders/transport.h).
#ifndef AFTERGLOW_FLIGHT_H
#define AFTERGLOW_FLIGHT_H
#include "shaders/color.h"
#include "shaders/media.h"
#include "shaders/path.h"
#include "shaders/random.h"
#include "shaders/ray.h"
#include "shaders/scene.h"
SHARED_BEGIN

// What the level's media leave of light along a segment, and what they add by themselves.
FN vec3 mediaTransmittance(Tracer tracer, Ray ray) { return mediaTransmittance(airOf(tracer), ray.origin, ray.direction, ray.far); }
FN vec3 mediaEmission(Tracer tracer, Ray ray) { return mediaEmission(airOf(tracer), ray.origin, ray.direction, ray.far); }

// Free flight along `ray`: where the next collision with a medium lies (distance >= ray.far: none), the weight of the path that goes on,
// and the mean cosine there. The distance is drawn for one channel, chosen in proportion to what the path carries of each, and weighted for
// all: pdf = sum of share * pdf of the channel. So no flight makes the sum of the channels larger, where an even choice lets that of a long
// walk through air of several colours grow without bound.
struct Flight {
    float distance;
    vec3 weight;
    float g;
    uint scattered;
};
FN Flight flyThroughMedia(Tracer tracer, Ray ray, vec3 throughput, INOUT(Sampler) random)
{
    Flight flight = Flight(ray.far, vec3(1.0f), 0.0f, 0u);
    Air air = airOf(tracer);
    if (mediumCount(air) == 0u) return flight;
    float position = 0.0f;
    float carried = throughput.x + throughput.y + throughput.z;
    vec3 share = carried > 0.0f ? throughput / carried : vec3(1.0f / 3.0f);
    float channel = next1(random);
    float remaining = -log(1.0f - next1(random)); // optical depth until the collision, in the drawn channel
    vec3 depth = vec3(0.0f);
    while (position < ray.far) {
        Stretch here = stretchFrom(air, ray.origin, ray.direction, ray.far, position);
        float drawn = channel < share.x ? here.extinction.x : channel < share.x + share.y ? here.extinction.y : here.extinction.z;
        float step = here.end - position;
        if (drawn * step > remaining) {
            step = remaining / drawn;
            depth += here.extinction * step;
            vec3 passed = exp(-depth);
            float pdf = dot(here.extinction * passed, share);
            flight.distance = position + step;
            flight.weight = pdf > 0.0f ? here.scattering * passed / pdf : vec3(0.0f);
            float total = luminance(here.scattering);
            flight.g = total > 0.0f ? here.cosine / total : 0.0f;
            flight.scattered = 1u;
            return flight;
        }
        remaining -= drawn * step;
        depth += here.extinction * step;
        position = here.end;
    }
    vec3 passed = exp(-depth);
    float pdf = dot(passed, share);
    flight.weight = pdf > 0.0f ? passed / pdf : vec3(0.0f);
    return flight;
}

SHARED_END
#endif
