#include "engine/scene/extras.hpp"
#include <fmt/format.h> // before error.hpp: it has a member called `check`

#include "engine/core/error.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/repair.hpp"
#include "shaders/spectrum.h"
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr const char* kOutOfRange = "ag_ extras outside their range";
constexpr float kLargestValue = 1e18f;
constexpr float kSmallestSize = 1e-3f;                  // m, of what is placed by hand
constexpr double kCoolest = 1000.0, kHottest = 40000.0; // K: embers and the hottest stars that one sees

void warn(const Extras& extras, const std::string& sentence) { extras.scene.warnings.push_back(extras.owner + ": " + sentence); }

// The key's value when it is of the kind that `fits` asks for; else nothing, with a warning if it is there.
const json* find(const Extras& extras, const char* key, const char* kind, bool (*fits)(const json&))
{
    const json& value = member(extras.values, key);
    if (value.is_null()) return nullptr;
    if (fits(value)) return &value;
    warn(extras, std::string(key) + " is not " + kind + ", so it is ignored");
    return nullptr;
}

bool isNumber(const json& value) { return value.is_number(); }
bool isText(const json& value) { return value.is_string(); }
bool isSwitch(const json& value) { return value.is_boolean() || value.is_number(); } // Blender writes 0 and 1
bool isColor(const json& value)
{
    if (value.is_number()) return true; // grey
    return value.is_array() && value.size() >= 3 && std::all_of(value.begin(), value.end(), isNumber);
}

std::optional<float> numberOf(const Extras& extras, const char* key, float lower, float upper)
{
    const json* value = find(extras, key, "a number", isNumber);
    if (!value) return std::nullopt;
    return clamped(value->get<double>(), lower, upper, extras.scene.dropped, kOutOfRange);
}

vec3 colorIn(const json& value, Scene& scene)
{
    const dvec3 color =
        value.is_number() ? dvec3(value.get<double>()) : dvec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
    return clamped(color, 0.0f, kLargestValue, scene.dropped, kOutOfRange);
}

std::optional<vec3> colorOf(const Extras& extras, const char* key)
{
    const json* value = find(extras, key, "a number or three", isColor);
    if (!value) return std::nullopt;
    return colorIn(*value, extras.scene);
}

std::optional<bool> switchOf(const Extras& extras, const char* key)
{
    const json* value = find(extras, key, "true or false", isSwitch);
    if (!value) return std::nullopt;
    return value->is_boolean() ? value->get<bool>() : value->get<double>() != 0.0;
}

std::string textOf(const Extras& extras, const char* key)
{
    const json* value = find(extras, key, "text", isText);
    return value ? value->get<std::string>() : "";
}

// A key that starts with ag_ and means nothing here is a slip of the keyboard.
void tellUnknown(const Extras& extras, std::initializer_list<std::string_view> known)
{
    if (!extras.values.is_object()) return;
    for (const auto& [key, value] : extras.values.items())
        if (key.starts_with("ag_") && std::find(known.begin(), known.end(), key) == known.end())
            warn(extras, key + " means nothing here, so it is ignored");
}

// The image's radiance, in three channels; empty when it cannot be read, which is told.
Image readSkyImage(const Document& document, const Extras& extras, const std::string& uri)
{
    try {
        const Image read = readImage(besideLevel(document.path, uri));
        Image image(read.width, read.height, 3); // an alpha is no radiance
        for (int y = 0; y < read.height; ++y)
            for (int x = 0; x < read.width; ++x)
                for (int c = 0; c < 3; ++c) image.at(x, y)[c] = read.at(x, y)[std::min(c, read.channels - 1)];
        repairRadiance(image, extras.scene.dropped);
        return image;
    } catch (const Error& error) {
        warn(extras, std::string(error.what()) + ": the sky is uniform instead");
        ++extras.scene.dropped["textures that cannot be read"];
        return {};
    }
}

void readSky(const Document& document, const Extras& extras)
{
    Sky& sky = extras.scene.sky;
    const std::string uri = textOf(extras, "ag_sky_image");
    if (!uri.empty()) sky.image = readSkyImage(document, extras, uri);
    const vec3 otherwise(sky.image.pixels.empty() ? 0.0f : 1.0f); // black, or the image as it is
    const float strength = numberOf(extras, "ag_sky_strength", 0.0f, kLargestValue).value_or(1.0f);
    sky.radiance = colorOf(extras, "ag_sky_radiance").value_or(otherwise) * strength;
    sky.rotation = radians(numberOf(extras, "ag_sky_rotation_deg", -kLargestValue, kLargestValue).value_or(0.0f));
}

bool isRamp(const json& value)
{
    return value.is_array() && !value.empty() && value.size() <= 64 && std::all_of(value.begin(), value.end(), isColor);
}
bool isNumbers(const json& value) { return value.is_array() && std::all_of(value.begin(), value.end(), isNumber); }

// Tones from the darkest on; where each begins, if it is said, otherwise in equal steps.
std::vector<ToonStep> readToonRamp(const Extras& extras)
{
    const json *tones = find(extras, "ag_toon_ramp", "a list of 1 to 64 greys or colours", isRamp),
               *edges = find(extras, "ag_toon_edges", "a list of numbers", isNumbers);
    if (!tones) return {};
    if (edges && edges->size() + 1 != tones->size()) {
        warn(extras, "ag_toon_edges are not one fewer than the tones of ag_toon_ramp, so they are ignored");
        edges = nullptr;
    }
    std::vector<ToonStep> ramp;
    for (std::size_t i = 0; i < tones->size(); ++i) {
        ToonStep step = evenToonStep(uint(i), uint(tones->size()));
        step.tone = colorIn((*tones)[i], extras.scene);
        if (edges && i > 0) step.edge = clamped((*edges)[i - 1].get<double>(), 0.0f, 1.0f, extras.scene.dropped, kOutOfRange);
        if (i > 0) step.edge = std::max(step.edge, ramp.back().edge);
        ramp.push_back(step);
    }
    return ramp;
}

void readDisplay(const Extras& extras)
{
    Display& display = extras.scene.display;
    display.exposureEv = numberOf(extras, "ag_exposure_ev", -64.0f, 64.0f);
    display.bloom = numberOf(extras, "ag_bloom", 0.0f, 1.0f).value_or(0.0f);
    display.toonSteps = int(numberOf(extras, "ag_toon_steps", 1.0f, 64.0f).value_or(float(display.toonSteps)));
    display.outlinePixels = numberOf(extras, "ag_outline_px", 0.0f, 64.0f).value_or(0.0f);
    display.outlineColor = colorOf(extras, "ag_outline_color").value_or(vec3(0.0f));
    if (const auto degrees = numberOf(extras, "ag_outline_crease_deg", 0.0f, 180.0f)) display.outlineCrease = radians(*degrees);
    display.toonRamp = readToonRamp(extras);

    const std::string style = textOf(extras, "ag_style"), curve = textOf(extras, "ag_tone_curve");
    display.toon = style == "toon";
    if (!style.empty() && style != "toon") warn(extras, "ag_style \"" + style + "\" is unknown; \"toon\" is the one there is");
    if (curve == "none")
        display.curve = ToneCurve::none;
    else if (curve == "reinhard")
        display.curve = ToneCurve::reinhard;
    else if (curve == "hable")
        display.curve = ToneCurve::hable;
    else if (!curve.empty() && curve != "aces")
        warn(extras, "ag_tone_curve \"" + curve + "\" is unknown; none, reinhard, aces and hable are known");
}

// ag_kelvin: the light's colour times that of a black body, at the luminance that it has without. The light is the one that the scene gets
// next.
void readTemperature(const Extras& extras, Light& light)
{
    const json* said = find(extras, "ag_kelvin", "a number", isNumber);
    if (!said) return;
    const double kelvin = said->get<double>();
    if (!(kelvin >= kCoolest && kelvin <= kHottest)) {
        warn(extras, fmt::format("ag_kelvin {:g} lies outside {:g} to {:g} K, so it is ignored", kelvin, kCoolest, kHottest));
        return;
    }
    const vec3 tinted = light.intensity * intoGamut(blackbodyColor(float(kelvin)));
    const float gain = luminance(light.intensity) / luminance(tinted);
    if (!(gain <= kLargestValue)) { // a blue light of embers
        warn(extras, fmt::format("of the light's colour nothing is left at ag_kelvin {:g}, so that is ignored", kelvin));
        return;
    }
    extras.scene.hotLights[uint(extras.scene.lights.size())] = {float(kelvin), light.intensity * (gain / blackbodyXyz(float(kelvin)).y)};
    light.intensity = tinted * gain;
}
}

std::optional<Medium> readMedium(const Extras& extras)
{
    const auto scattering = colorOf(extras, "ag_fog_scattering"), absorption = colorOf(extras, "ag_fog_absorption");
    const auto emission = colorOf(extras, "ag_fog_emission");
    if (!scattering && !absorption && !emission) return std::nullopt;
    Medium medium{};
    medium.scattering = scattering.value_or(vec3(0.0f));
    medium.absorption = absorption.value_or(vec3(0.0f));
    medium.emission = emission.value_or(vec3(0.0f));
    medium.g = numberOf(extras, "ag_fog_g", -1.0f, 1.0f).value_or(0.0f);
    return medium;
}

void readSceneExtras(const Document& document, const Extras& extras)
{
    tellUnknown(extras,
                {"ag_sky_radiance", "ag_sky_image", "ag_sky_strength", "ag_sky_rotation_deg", "ag_fog_scattering", "ag_fog_absorption",
                 "ag_fog_emission", "ag_fog_g", "ag_exposure_ev", "ag_tone_curve", "ag_bloom", "ag_style", "ag_toon_steps", "ag_toon_ramp",
                 "ag_toon_edges", "ag_outline_px", "ag_outline_color", "ag_outline_crease_deg", "ag_truth"});
    readSky(document, extras);
    readDisplay(extras);
}

void readMaterialExtras(const Extras& extras, Material& material)
{
    tellUnknown(extras, {"ag_sigma_deg", "ag_lambert", "ag_toon", "ag_toon_ramp", "ag_toon_edges"});
    material.sigma = radians(numberOf(extras, "ag_sigma_deg", 0.0f, 90.0f).value_or(0.0f));
    if (switchOf(extras, "ag_lambert").value_or(false)) material.flags |= kMaterialLambert;
    // The material is the one that the scene gets next
    const std::vector<ToonStep> ramp = readToonRamp(extras);
    const bool plain = !switchOf(extras, "ag_toon").value_or(true);
    if (plain || !ramp.empty()) extras.scene.toonRamps[uint(extras.scene.materials.size())] = plain ? std::vector<ToonStep>{} : ramp;
}

void readObjectExtras(const Extras& extras, Object& object)
{
    tellUnknown(extras, {"ag_static", "ag_texels_per_metre", "ag_mirror", "ag_portal", "ag_lightmap", "ag_fog_scattering",
                         "ag_fog_absorption", "ag_fog_emission", "ag_fog_g"});
    object.isStatic = switchOf(extras, "ag_static").value_or(true);
    object.texelsPerMetre = numberOf(extras, "ag_texels_per_metre", 0.0f, 1e6f).value_or(0.0f);
    object.mirror = switchOf(extras, "ag_mirror").value_or(false);
    object.portal = textOf(extras, "ag_portal");
}

void readLightExtras(const Extras& extras, Light& light)
{
    tellUnknown(extras, {"ag_radius_m", "ag_sun_angle_deg", "ag_bake", "ag_kelvin"});
    readTemperature(extras, light);
    light.radius = numberOf(extras, "ag_radius_m", 0.0f, kLargestValue).value_or(0.0f);
    const float diameter = numberOf(extras, "ag_sun_angle_deg", 0.0f, 180.0f).value_or(0.0f); // of the disc, as seen
    light.sinAngle = float(std::sin(radians(0.5 * double(diameter))));

    const std::string bake = textOf(extras, "ag_bake");
    if (bake == "all")
        light.bake = kBakeAll;
    else if (bake == "none")
        light.bake = kBakeNone;
    else if (!bake.empty() && bake != "indirect")
        warn(extras, "ag_bake \"" + bake + "\" is unknown; indirect, all and none are known");
}

void readEmptyExtras(const Extras& extras, const dmat4& toWorld, const std::string& name)
{
    tellUnknown(extras, {"ag_probe_volume", "ag_reflection_probe"});
    // Either {"spacing_m": 1} or, flat, the value itself.
    const json &volume = member(extras.values, "ag_probe_volume"), &probe = member(extras.values, "ag_reflection_probe");
    if (!volume.is_null()) {
        const auto spacing = volume.is_object() ? numberOf({volume, extras.owner, extras.scene}, "spacing_m", kSmallestSize, kLargestValue)
                                                : numberOf(extras, "ag_probe_volume", kSmallestSize, kLargestValue);
        extras.scene.probeVolumes.push_back({name, mat4(toWorld), spacing.value_or(1.0f)});
    }
    if (!probe.is_null()) {
        const auto half =
            probe.is_object() ? colorOf({probe, extras.owner, extras.scene}, "half_extents_m") : colorOf(extras, "ag_reflection_probe");
        extras.scene.reflectionProbes.push_back({name, vec3(toWorld[3]), max(half.value_or(vec3(1.0f)), vec3(kSmallestSize))});
    }
}
}
