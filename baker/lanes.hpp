// What each ray of a packet has, side by side: loops over lanes have no branch, and the compiler does eight or sixteen of them at once.
#pragma once
#include "shaders/light.h"

namespace afterglow
{
using namespace shared;

constexpr int kPacket = 16; // rays that Embree follows together

struct Lanes {
    alignas(64) float of[kPacket];

    float& operator[](int i) { return of[i]; }
    float operator[](int i) const { return of[i]; }
};

struct Lanes3 {
    Lanes x, y, z;

    vec3 operator[](int i) const { return vec3(x[i], y[i], z[i]); }
    void set(int i, vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
    void add(int i, vec3 v) { x[i] += v.x, y[i] += v.y, z[i] += v.z; }
};

// Random numbers of light samples, [0, 1): which light, and where on it.
struct DrawLanes {
    Lanes choice, x, y;
};

// Samples of lights: LightSample (shaders/light.h), whose units and space they have.
struct LightLanes {
    Lanes3 direction, radiance;
    Lanes distance, pdf;
    Lanes delta; // 1 or 0

    LightSample operator[](int i) const { return {direction[i], distance[i], radiance[i], pdf[i], delta[i] > 0.0f ? 1u : 0u}; }
    void set(int i, const LightSample& light)
    {
        direction.set(i, light.direction), radiance.set(i, light.radiance);
        distance[i] = light.distance, pdf[i] = light.pdf, delta[i] = float(light.delta);
    }
};

struct RayLanes {
    Lanes3 origin, direction;
    Lanes far;
    alignas(64) int asked[kPacket]; // -1: is to be asked; 0: there is no such ray
};
}
