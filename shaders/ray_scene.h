// The level as rays meet it, the same in both tracers: triangles of the world, those that end every ray before those that may not.
#ifndef AFTERGLOW_RAY_SCENE_H
#define AFTERGLOW_RAY_SCENE_H
#include "shaders/frame.h"
#include "shaders/scene.h"
#include "shaders/texel_range.h"
SHARED_BEGIN

// A triangle of the GPU's tracer: Hit::triangle counts these. Their order is the acceleration structure's.
struct RayTriangle {
    uint vertex[3]; // into the level's vertices
    uint instance;  // into its instances
};

// A vertex of a placed mesh, in the world.
FN Vertex placedVertex(IN(Instance) instance, Vertex v)
{
    v.position = instance.toWorld * vec4(v.position, 1.0f);
    v.normal = safeNormalize(instance.normalToWorld * v.normal, vec3(0.0f, 1.0f, 0.0f));
    v.tangent = vec4(safeNormalize(mat3(instance.toWorld) * vec3(v.tangent), makeFrame(v.normal).tangent), v.tangent.w);
    return v;
}

// Some rays go straight on through such a surface; any other ends every ray.
FN bool mayTint(IN(Material) m) { return m.transmission > 0.0f && !(m.thickness > 0.0f); } // thin glass
FN bool mayLetThrough(IN(Material) m) { return mayTint(m) || (m.flags & (kMaterialAlphaMask | kMaterialAlphaBlend)) != 0u; }

// Specialization constants of every pass that traces rays (shaders/trace.glsl): some triangle of the level may let rays through, and some
// may tint them.
const uint kTraceFiltered = 100u;
const uint kTraceTinted = 101u;
const uint kTraceExact = 102u; // textures texel by texel, not by the device's filter

// Ray programs: those of a surface's kind stand together in the shader binding table, one for each kind of ray.
const uint kRayKinds = 2u;
const uint kRayNearest = 0u; // asks what it meets first
const uint kRayShadow = 1u;  // asks what of light passes
const uint kHitOpaque = 0u;
const uint kHitFiltered = 1u; // may let rays through

SHARED_END
#endif
