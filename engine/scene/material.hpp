// glTF's materials, and the extensions that say more, as Material of shaders/scene.h.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/scene.hpp"

namespace afterglow
{
// Rough grey plaster, albedo 0.8: what a primitive without a material is made of. (glTF's own default is a white metal, which no author
// means and which would leave lightmaps black.)
Material plaster();

// Fills the level's materials, their names and textures, in the file's order. Says which of them show their textures by TEXCOORD_1 alone:
// these read uv0 from now on, and their primitives are to hold TEXCOORD_1 there, because the baker's atlas takes uv1.
std::vector<bool> readMaterials(const Document& document, Scene& scene);

// The lowest roughness that the material shows anywhere, its texture's included.
float lowestRoughness(const Scene& scene, const Material& material);

// Whether it mirrors so much, and so sharply, that reflection probes are placed for it: metals, and smooth dielectrics
// (shaders/reflection.h).
bool isGlossy(const Scene& scene, const Material& material);
}
