// Which pixels have a mirrored ray of their own: those whose interfaces are smooth enough, and that no other eye serves.
#ifndef AFTERGLOW_MIRROR_GLSL
#define AFTERGLOW_MIRROR_GLSL
#include "engine/effects/reflection/reflection.h"
#include "shaders/bindings.glsl"
#include "shaders/gbuffer.h"

bool mirrors(GBufferTexel t)
{
    if (t.mirrored != 0u || !(reflectionShare(t.roughness) > 0.0)) return false; // the first: an eye behind the mirror sees it
    if ((materials[t.material].flags & kMaterialLambert) != 0u) return false;
    return t.metallic > 0.0 || materials[t.material].specular > 0.0;
}

#endif
