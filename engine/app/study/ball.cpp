#include "engine/app/study/ball.hpp"
#include "baker/cube.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/upload/split_sum.hpp"
#include "shaders/frame.h"
#include "shaders/gpu_baked.h"
#include "shaders/microfacet.h"
#include "shaders/random.h"
#include "shaders/reflection.h"
#include "shaders/sh.h"
#include <array>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kEdge = 96;         // px of the picture
constexpr float kRadius = 0.9f;   // of the ball, of half the picture
constexpr std::size_t kGloss = 2; // the mip of a prefiltered probe that has the glossy ball's roughness
constexpr uint kBallSeed = 1u;

// Calls shade(normal, towards the eye) for each pixel of the ball; beside it the surroundings are seen.
template <class Shade>
Image ballOf(const Studio& studio, Shade shade)
{
    const ReflectionProbe& probe = studio.baked.reflections.front();
    const mat3 turned(studio.camera.toWorld);
    const vec3 toEye = normalize(turned[2]);
    Image image(kEdge, kEdge, 3);
    for (int y = 0; y < kEdge; ++y)
        for (int x = 0; x < kEdge; ++x) {
            const vec2 at = vec2(2.0f * (float(x) + 0.5f) / kEdge - 1.0f, 1.0f - 2.0f * (float(y) + 0.5f) / kEdge) / kRadius;
            const float inside = 1.0f - dot(at, at);
            vec3 value;
            if (inside > 0.0f)
                value = shade(normalize(turned * vec3(at, std::sqrt(inside))), toEye);
            else
                value = cubeRadiance(probe.mips[0], probe.size, normalize(turned * vec3(at, -1.0f)));
            for (int c = 0; c < 3; ++c) image.at(x, y)[c] = value[c];
        }
    return image;
}

// Each texel of the probe: direction, solid angle, radiance.
template <class Work>
void everyTexel(const ReflectionProbe& probe, Work work)
{
    const int n = probe.size;
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                work(normalize(cubeDirection(face, (vec2(float(i), float(j)) + 0.5f) / float(n))), cubeTexelSolidAngle(i, j, n),
                     probe.mips[0][std::size_t((face * n + j) * n + i)]);
}
}

Image matteBall(const Studio& studio, double order)
{
    const ReflectionProbe& probe = studio.baked.reflections.front();
    if (order == kExact)
        return ballOf(studio, [&](vec3 normal, vec3) {
            vec3 sum(0.0f);
            everyTexel(probe, [&](vec3 d, float solidAngle, vec3 radiance) {
                sum += radiance * (solidAngle * std::max(dot(d, normal), 0.0f) * kInvPi);
            });
            return sum;
        });
    Sh9 sh = shZero();
    everyTexel(probe, [&](vec3 d, float solidAngle, vec3 radiance) { shAdd(sh, d, radiance * solidAngle); });
    const float bands[] = {kShCosine0, kShCosine1, kShCosine2};
    for (int i = 0; i < 9; ++i) sh.c[i] *= double(shBand(i)) <= order ? bands[shBand(i)] : 0.0f;
    return ballOf(studio, [&](vec3 normal, vec3) { return shEvaluate(sh, normal); });
}

Image glossyBall(const Studio& studio, double samples)
{
    const ReflectionProbe& probe = studio.baked.reflections.front();
    const std::size_t mip = std::min(kGloss, probe.mips.size() - 1);
    const float roughness = reflectionRoughness(float(mip), float(probe.mips.size()));
    if (samples == kSplitSum) {
        std::array<float, kSplitSumSize> table; // of a white surface, by the cosine, as the runtime has one
        for (int i = 0; i < kSplitSumSize; ++i) {
            const vec2 parts = splitSum(float(i) / (kSplitSumSize - 1), roughness);
            table[std::size_t(i)] = parts.x + parts.y;
        }
        return ballOf(studio, [&](vec3 normal, vec3 toEye) {
            const float share = table[std::size_t(std::lround(std::max(dot(normal, toEye), 0.0f) * (kSplitSumSize - 1)))];
            return cubeRadiance(probe.mips[mip], probe.size >> mip, mirrorDirection(toEye, normal)) * share;
        });
    }
    const vec2 alpha = roughnessToAlpha(roughness, 0.0f);
    uint pixel = 0;
    return ballOf(studio, [&](vec3 normal, vec3 toEye) {
        const Frame frame = makeFrame(normal);
        const vec3 o = toLocal(frame, toEye);
        vec3 sum(0.0f);
        ++pixel;
        for (uint i = 0; i < uint(samples); ++i) {
            shared::Sampler random = makeSampler(hash2(pixel, kBallSeed), i); // not the GPU's, that filters textures
            const vec3 h = sampleGgxVisible(o, alpha, next2(random));
            const vec3 in = mirrorDirection(o, h);
            if (!(in.z > 0.0f)) continue;
            sum += cubeRadiance(probe.mips[0], probe.size, toWorld(frame, in)) * (ggxG2(o, in, alpha) / ggxG1(o, alpha));
        }
        return sum / float(samples);
    });
}
}
