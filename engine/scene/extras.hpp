// What glTF cannot say: the ag_ keys of extras, as an artist types them into Blender's custom properties. A value of the wrong kind and a
// key that nobody knows are told in the level's warnings, and the default stands.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/scene.hpp"
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace afterglow
{
// The extras of one thing in the file, and how to name it in a warning.
struct Extras {
    const nlohmann::json& values;
    std::string owner; // `node "Lamp"`
    Scene& scene;
};

void readSceneExtras(const Document& document, const Extras& extras); // sky, display
void readMaterialExtras(const Extras& extras, Material& material);
void readObjectExtras(const Extras& extras, Object& object);
void readLightExtras(const Extras& extras, Light& light);
void readEmptyExtras(const Extras& extras, const dmat4& toWorld, const std::string& name); // probes placed by hand

// The medium that the extras of the scene or of a mesh node speak of (bounds not set), or nothing.
std::optional<Medium> readMedium(const Extras& extras);
}
