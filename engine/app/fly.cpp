#include "engine/app/fly.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr float kTurn = 0.004f;       // rad/pixel: a drag over half of a 1280 pixel window turns by 150 degrees
constexpr float kSteepest = 1.55f;    // rad above or below the horizon: short of straight up, where there is no heading
constexpr float kFast = 4.0f;         // times, with shift
constexpr double kLongestStep = 0.25; // s: a frame that took longer (a shader was compiled) does not throw the eye through a wall

void turn(Camera& camera, vec2 pixels)
{
    const vec3 ahead = -normalize(vec3(camera.toWorld[2])), up(camera.toWorld[1]);
    // Straight up or down the heading is where the top of the picture points
    const vec3 heading = std::abs(ahead.y) < 0.999f ? ahead : ahead.y > 0.0f ? -up : up;
    const float yaw = std::atan2(-heading.x, -heading.z) - kTurn * pixels.x;
    const float pitch = std::clamp(std::asin(std::clamp(ahead.y, -1.0f, 1.0f)) - kTurn * pixels.y, -kSteepest, kSteepest);
    const vec3 z(std::sin(yaw) * std::cos(pitch), -std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    const vec3 x(std::cos(yaw), 0.0f, -std::sin(yaw));
    camera.toWorld = mat4(vec4(x, 0), vec4(cross(z, x), 0), vec4(z, 0), camera.toWorld[3]);
}
}

Camera flown(Camera camera, const Controls& controls, float speed)
{
    if (controls.look != vec2(0.0f)) turn(camera, controls.look);
    const float metres = speed * (controls.fast ? kFast : 1.0f) * float(std::min(controls.seconds, kLongestStep));
    const vec3 right(camera.toWorld[0]), back(camera.toWorld[2]);
    const vec3 step = right * controls.move.x + vec3(0, 1, 0) * controls.move.y - back * controls.move.z;
    camera.toWorld[3] += vec4(step * metres, 0.0f);
    return camera;
}

float flyingSpeed(const Scene& scene) { return std::clamp(0.2f * length(scene.upper - scene.lower), 0.01f, 20.0f); }
}
