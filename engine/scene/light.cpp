#include "engine/scene/light.hpp"
#include "engine/scene/fields.hpp"
#include "shaders/constants.h"
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
constexpr float kStrongest = 1e18f;
constexpr const char* kOutOfRange = "light values outside their range";
}

std::optional<Light> readLight(const nlohmann::json& source, const dmat4& toWorld, Dropped& dropped)
{
    Light light{};
    const std::string type = text(source, "type");
    if (type != "point" && type != "spot" && type != "directional")
        throw Malformed("a light of type \"" + type + "\" is not one of glTF's");
    light.type = type == "point" ? kLightPoint : type == "spot" ? kLightSpot : kLightDirectional;
    const dvec3 intensity = triple(source, "color", dvec3(1.0)) * number(source, "intensity", 1.0);
    light.intensity = clamped(intensity, 0.0f, kStrongest, dropped, kOutOfRange);
    light.range = clamped(number(source, "range", 0.0), 0.0f, kStrongest, dropped, kOutOfRange);
    light.position = vec3(toWorld[3]);

    const dvec3 along = -dvec3(toWorld[2]);
    const double size = length(along);
    const bool aimless = light.type != kLightPoint && !(size > 0.0);
    light.direction = size > 0.0 ? vec3(along / size) : vec3(0, 0, -1);

    const nlohmann::json& spot = member(source, "spot");
    const float outer = clamped(number(spot, "outerConeAngle", 0.25 * double(kPi)), 1e-4f, kHalfPi, dropped, kOutOfRange);
    const float inner = clamped(number(spot, "innerConeAngle", 0.0), 0.0f, outer, dropped, kOutOfRange);
    light.cosOuter = std::cos(outer);
    light.cosInner = std::cos(inner);
    if (light.intensity == vec3(0.0f) || aimless) {
        ++dropped["lights without power or direction"];
        return std::nullopt;
    }
    return light;
}
}
