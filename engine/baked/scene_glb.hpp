// scene.glb, the level as plain glTF: what the level's own file says about materials, textures, lights, cameras, names and extras, with the
// atlas's TEXCOORD_1, each object's place in the lightmap and its levels of detail. Any viewer opens it.
#pragma once
#include "engine/baked/baked.hpp"

namespace afterglow
{
// The file, and the name and bytes of the sky's picture that lies beside it, when the level has one.
struct SceneFiles {
    std::vector<std::uint8_t> glb;
    std::string skyName;
    std::vector<std::uint8_t> sky;
};

// Reads the level's file (baked.scene.path) again for what a Scene does not keep. Throws Error.
SceneFiles writeScene(const Baked& baked);

// Fills scene, places and lods. Throws Error.
void readScene(const std::filesystem::path& glb, Baked& baked);
}
