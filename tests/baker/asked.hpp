// What there is of light in a small level: at a point, and along a narrow look upwards.
#pragma once
#include "baker/baker.hpp"
#include "rooms.hpp"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
inline PointIrradiance irradianceAt(const Scene& scene, vec3 position, vec3 normal = vec3(0, 1, 0), int samples = 16384)
{
    ProbePoint point;
    point.position = position;
    point.normal = normal;
    Progress silent(ProgressStyle::none);
    return probeTruth(scene, {point}, samples, 5, 0, silent)[0];
}

// A picture of 16 x 16 pixels from the origin upwards, leaning towards +x by `slope`.
inline Image lookingUp(const Scene& scene, TruthOptions options, float slope = 0.0f, float fovY = 2e-4f)
{
    const vec3 back = -normalize(vec3(slope, 1.0f, 0.0f)), right(0.0f, 0.0f, 1.0f);
    options.camera.toWorld = mat4(vec4(right, 0.0f), vec4(cross(back, right), 0.0f), vec4(back, 0.0f), vec4(0, 0, 0, 1));
    options.camera.fovY = fovY;
    options.size = ivec2(16, 16);
    Progress silent(ProgressStyle::none);
    return truth(scene, options, silent);
}

inline Mean redOf(const Image& image)
{
    Mean mean;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) mean.add(double(image.pixels[i]));
    return mean;
}

inline Light pointLight(vec3 position, float radius)
{
    Light light{};
    light.type = kLightPoint;
    light.position = position;
    light.intensity = vec3(1.0f);
    light.radius = radius;
    return light;
}
}
