// What each ray of a packet has, side by side: loops over lanes have no branch, and the compiler does eight or sixteen of them at once.
#pragma once
#include "shaders/glsl.h"

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

// Rays that end, or point, alike.
struct RayLanes {
    Lanes3 origin, direction;
    Lanes far;
    alignas(64) int asked[kPacket]; // -1: is to be asked; 0: there is no such ray
};
}
