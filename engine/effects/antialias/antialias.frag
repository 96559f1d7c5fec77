#version 460
// One shown pixel: the new frame's sample, and the mean of the frames before, found again where the surface was.
#include "engine/effects/antialias/antialias.h"
#include "engine/effects/cubic.h"
#include "engine/effects/motion.h"

layout(constant_id = kAntialiasUpscale) const bool kUpscale = false;
layout(constant_id = kAntialiasMotion) const bool kMotion = false;

layout(push_constant, scalar) uniform Push { AntialiasPush push; };
layout(set = 1, binding = 0) uniform sampler2D imageTexture;
layout(set = 1, binding = 1) uniform sampler2D depthTexture;
layout(set = 1, binding = 2) uniform sampler2D motionTexture;
layout(set = 1, binding = 3) uniform sampler2D lastTexture;
layout(set = 1, binding = 4) uniform sampler2D lastDepthTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 gathered;
layout(location = 1) out float gatheredDepth;

// Finite, for what is kept is met again in every later frame.
vec3 drawn(ivec2 pixel)
{
    vec3 c = texelFetch(imageTexture, clamp(pixel, ivec2(0), textureSize(imageTexture, 0) - 1), 0).rgb;
    return vec3(displayInput(c.r), displayInput(c.g), displayInput(c.b));
}

// The drawn pixel of the sample that is nearest to the middle of the shown pixel, and whether it lies within the shown pixel.
ivec2 nearestDrawn(out bool within)
{
    within = true;
    if (!kUpscale) return ivec2(gl_FragCoord.xy);
    vec2 size = vec2(textureSize(imageTexture, 0)), shown = vec2(textureSize(lastTexture, 0));
    ivec2 pixel = clamp(ivec2(ceil(gl_FragCoord.xy * (size / shown) - push.jitter)) - 1, ivec2(0), ivec2(size) - 1);
    vec2 at = (vec2(pixel) + 0.5 + push.jitter) * (shown / size); // of the sample, in shown pixels
    within = floor(at) == floor(gl_FragCoord.xy);
    return pixel;
}

// The new frame between its samples, where none lies within the shown pixel.
vec3 interpolated()
{
    vec2 at = uv * vec2(textureSize(imageTexture, 0)) - push.jitter - 0.5;
    ivec2 corner = ivec2(floor(at));
    vec2 t = at - vec2(corner);
    return mix(mix(drawn(corner), drawn(corner + ivec2(1, 0)), t.x), mix(drawn(corner + ivec2(0, 1)), drawn(corner + 1), t.x), t.y);
}

// The drawn pixel, of those around, whose surface is nearest: an edge moves with what lies before it.
ivec2 nearestAround(ivec2 pixel)
{
    ivec2 last = textureSize(depthTexture, 0) - 1, nearest = pixel;
    float depth = -1.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
            float there = texelFetch(depthTexture, at, 0).r;
            if (there > depth) {
                depth = there;
                nearest = at;
            }
        }
    return nearest;
}

// How far what the drawn pixel shows has come since the last frame, in picture coordinates, and its depth there.
vec3 comeFrom(ivec2 pixel)
{
    vec2 size = vec2(textureSize(depthTexture, 0)), at = (vec2(pixel) + 0.5) / size, sampled = at + push.jitter / size;
    vec4 moved = kMotion ? texelFetch(motionTexture, pixel, 0) : vec4(0.0);
    vec4 then = moved.a > 0.0 ? moved : placeThen(push.toLast * vec4(uvToNdc(at), texelFetch(depthTexture, pixel, 0).r, 1.0));
    return vec3(then.xy - sampled, then.z);
}

// The past saw that depth, or something behind it: all that it saw around the point is not nearer. What has just come before the past is
// accepted, for bars thinner than a pixel come and go with the samples.
bool wasSeen(vec2 at, float depth)
{
    if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(1.0)))) return false;
    ivec2 size = textureSize(lastDepthTexture, 0), pixel = ivec2(floor(at * vec2(size)));
    float farthest = 2.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            farthest = min(farthest, texelFetch(lastDepthTexture, clamp(pixel + ivec2(x, y), ivec2(0), size - 1), 0).r);
    return depth >= farthest - (push.depthTolerance.x * depth + push.depthTolerance.y);
}

// The past at a point, by the cubic through its pixels: nine linear taps stand for sixteen. a: how many frames, linearly.
vec4 past(vec2 at)
{
    vec2 size = vec2(textureSize(lastTexture, 0)), p = at * size - 0.5, corner = floor(p), t = p - corner;
    vec4 wx = cubicWeights(t.x), wy = cubicWeights(t.y);
    vec3 x = vec3(corner.x - 1.0, corner.x + wx.z / (wx.y + wx.z), corner.x + 2.0), y = vec3(corner.y - 1.0, corner.y + wy.z / (wy.y + wy.z), corner.y + 2.0);
    vec3 sx = vec3(wx.x, wx.y + wx.z, wx.w), sy = vec3(wy.x, wy.y + wy.z, wy.w);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) sum += sx[i] * sy[j] * texture(lastTexture, (vec2(x[i], y[j]) + 0.5) / size).rgb;
    return vec4(max(sum, vec3(0.0)), texture(lastTexture, at).a);
}

// Mean and deviation of the new frame around the pixel, in luma and chroma.
void neighbours(ivec2 pixel, out vec3 mean, out vec3 deviation)
{
    vec3 sum = vec3(0.0), squares = vec3(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec3 c = toLumaChroma(drawn(pixel + ivec2(x, y)));
            sum += c;
            squares += c * c;
        }
    mean = sum / 9.0;
    deviation = sqrt(max(squares / 9.0 - mean * mean, vec3(0.0)));
}

void main()
{
    bool within;
    ivec2 pixel = nearestDrawn(within);
    gatheredDepth = texelFetch(depthTexture, pixel, 0).r;
    vec3 now = within ? drawn(pixel) : interpolated();
    vec4 last = vec4(0.0);
    if (push.still != 0u) {
        last = texelFetch(lastTexture, ivec2(gl_FragCoord.xy), 0);
    } else if (push.most > 0.0) {
        ivec2 nearest = nearestAround(pixel);
        vec2 at = uv + comeFrom(nearest).xy;
        if (wasSeen(at, comeFrom(pixel).z)) {
            last = past(at);
            vec3 mean, deviation;
            neighbours(pixel, mean, deviation);
            last.rgb = max(fromLumaChroma(believed(toLumaChroma(last.rgb), mean, deviation)), vec3(0.0));
        }
    }
    float count = min(last.a, push.most);
    float own = within ? 1.0 : kGuessed;
    if (push.still != 0u && kUpscale) { // once there are true samples the mean is of them alone
        if (count < 1.0) count = 0.0;
        else if (!within) own = 0.0;
    }
    gathered = vec4(last.rgb + (now - last.rgb) * (own / (count + own)), count + own);
}
