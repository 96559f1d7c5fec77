// A path-traced picture: the ray and the random numbers of each sample of each pixel, the same in both tracers.
#ifndef AFTERGLOW_PICTURE_H
#define AFTERGLOW_PICTURE_H
#include "shaders/camera.h"
#include "shaders/random.h"
#include "shaders/ray.h"
SHARED_BEGIN

struct Picture {
    mat4x3 toWorld;   // of the camera, which looks along its -z
    vec2 diagonal;    // of its projection: m[0][0] and m[1][1]
    uint perspective; // 0: orthographic
    uint portalDepth; // through how many portals it sees
    uvec2 size;       // px
    uint seed;
};

FN Sampler pixelSampler(IN(Picture) picture, uvec2 pixel, uint index)
{
    return makeSampler(hash2(pixel.y * 65536u + pixel.x, picture.seed), index);
}

// Through a point of the pixel.
FN Ray pixelRay(IN(Picture) picture, uvec2 pixel, vec2 inPixel)
{
    vec2 uv = (vec2(pixel) + inPixel) / vec2(picture.size);
    if (picture.perspective != 0u)
        return Ray(picture.toWorld[3], normalize(mat3(picture.toWorld) * viewDirection(uv, picture.diagonal)), kRayFar);
    vec3 from = picture.toWorld * vec4(uvToNdc(uv) / picture.diagonal, 0.0f, 1.0f);
    return Ray(from, normalize(-picture.toWorld[2]), kRayFar);
}

// The front of a surface in which one sees what lies before its twin.
struct Portal {
    mat4x3 through; // a point before it -> before its twin; rigid
    vec3 front;     // unit normals: of itself
    vec3 beyond;    // and of its twin, on the side that is seen
};

SHARED_END
#endif
