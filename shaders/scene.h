// What a level is made of, as both columns see it: the baker holds these structs in vectors, the runtime in buffers of scalar layout.
// Everything is linear Rec.709, metres, radians, right-handed, +Y up; radiance in the level's own scene units.
#ifndef AFTERGLOW_SCENE_H
#define AFTERGLOW_SCENE_H
#include "shaders/glsl.h"
SHARED_BEGIN

struct Vertex {
    vec3 position; // object space, m
    vec3 normal;   // object space, unit
    vec4 tangent;  // xyz unit, w = handedness of the bitangent: cross(normal, tangent) * w
    vec2 uv0;      // glTF TEXCOORD_0, v grows downwards
    vec2 uv1;      // glTF TEXCOORD_1: the level's own until the baker's atlas replaces it
    uint color;    // COLOR_0 as packUnorm4x8, linear; white when absent
};

// A texture seen through KHR_texture_transform: uv' = mat2(matrix) * uv + offset.
struct TextureRef {
    int texture; // index into the level's textures, -1: none, the factor stands alone
    uint uvSet;  // 0 or 1
    vec4 matrix; // columns of the 2x2
    vec2 offset;
};

const uint kMaterialDoubleSided = 1u; // emission leaves both sides
const uint kMaterialAlphaMask = 2u;   // alpha >= alphaCutoff keeps
const uint kMaterialAlphaBlend = 4u;  // alpha is the chance that a ray meets the surface
const uint kMaterialUnlit = 8u;       // KHR_materials_unlit: base colour is the radiance that the camera sees
const uint kMaterialLambert = 16u;    // ag_lambert: diffuse only, no specular layer
const uint kMaterialMirror = 32u;     // ag_mirror of the node, or roughness 0 metal: a planar reflection is called for

struct Material {
    vec4 baseColor; // factor; rgb albedo (or metal's reflectance at normal incidence), a = alpha
    vec3 emission;  // radiance: emissiveFactor * emissiveStrength
    float metallic;
    float roughness;    // perceptual; alpha = roughness^2
    float ior;          // 1.5 when absent
    float transmission; // KHR_materials_transmission
    float specular;     // KHR_materials_specular specularFactor: scales the dielectric layer
    vec3 specularColor;
    float anisotropy;          // KHR_materials_anisotropy strength
    float anisotropyRotation;  // radians, from the tangent
    vec3 attenuationColor;     // KHR_materials_volume
    float attenuationDistance; // m, infinite when absent
    float thickness;           // m, 0: thin-walled
    float sigma;               // Oren-Nayar, radians (ag_sigma_deg)
    float alphaCutoff;
    float normalScale;
    uint flags; // kMaterial...
    TextureRef baseColorTexture;
    TextureRef metallicRoughnessTexture; // g = roughness, b = metallic
    TextureRef normalTexture;
    TextureRef emissiveTexture;
    TextureRef transmissionTexture; // r
};

const uint kInstanceStatic = 1u; // takes part in the bake; false: receives probes, casts nothing into the bake
const uint kInstanceMirror = 2u; // ag_mirror

// One primitive of one placed mesh: a draw call, a BLAS instance, a range of the baker's triangles.
struct Instance {
    mat4x3 toWorld;     // object to world
    mat3 normalToWorld; // inverse transpose of its linear part; normalize after use
    uint firstIndex;
    uint indexCount;
    uint firstVertex; // added to every index
    uint material;
    uint flags;         // kInstance...
    uint object;        // index of the placed mesh (node) in the level, for ids
    int lightmap;       // page of the lightmap, -1: none, use the probes
    vec2 lightmapScale; // page uv = uv1 * scale + offset
    vec2 lightmapOffset;
};

const uint kLightPoint = 0u;
const uint kLightSpot = 1u;
const uint kLightDirectional = 2u;

const uint kBakeIndirect = 0u; // the bake holds what bounced, the runtime adds the direct part
const uint kBakeAll = 1u;      // the bake holds both
const uint kBakeNone = 2u;     // the bake ignores the light

struct Light {
    vec3 position;  // world, m
    uint type;      // kLight...
    vec3 direction; // world, unit, the way the light travels (a glTF light shines along its -z)
    float radius;   // m: a sphere of this radius for point and spot lights; 0: a point
    vec3 intensity; // point, spot: radiant intensity (W/sr or cd); directional: irradiance on a facing surface (W/m2 or lx)
    float range;    // m: KHR_lights_punctual window, 0: infinite
    float cosInner; // spot: full intensity inside
    float cosOuter; // spot: nothing outside
    float sinAngle; // directional: sine of the disc's angular radius; 0: a delta direction
    uint bake;      // kBake...
};

// A homogeneous medium that fills a convex body: a box, cut by planes where the mesh node that carries it is no box along the axes.
struct Medium {
    vec3 scattering; // 1/m
    float g;         // Henyey-Greenstein mean cosine
    vec3 absorption; // 1/m
    uint wholeLevel; // 1: said of the scene
    vec3 lower;      // world bounds, m
    uint firstPlane; // of the level's medium planes: xyz unit normal that points outwards, w where it lies, dot(xyz, p) = w
    vec3 upper;
    uint planeCount; // 0: the box is the body
    vec3 emission;   // radiance that a metre sends out by itself
};

SHARED_END
#endif
