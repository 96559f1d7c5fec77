// Set 0, the scene: what a level and its bake are to every shader. engine/upload/scene_set.cpp fills it in this order.
// An index taken from here must be dynamically uniform, or wrapped in nonuniformEXT.
#ifndef AFTERGLOW_BINDINGS_GLSL
#define AFTERGLOW_BINDINGS_GLSL
#include "shaders/gpu_baked.h"
#include "shaders/scene.h"

layout(set = 0, binding = 0, scalar) readonly buffer Vertices { Vertex vertices[]; };
layout(set = 0, binding = 1, scalar) readonly buffer Materials { Material materials[]; };
layout(set = 0, binding = 2, scalar) readonly buffer Lights { Light lights[]; }; // those whose direct part the bake does not hold
layout(set = 0, binding = 3, scalar) readonly buffer Media { Medium media[]; };
layout(set = 0, binding = 4) uniform sampler2D textures[];
layout(set = 0, binding = 5) uniform sampler2D skyImage;
layout(set = 0, binding = 6) uniform sampler2D lightmaps[]; // irradiance / pi; after all pages, if it is drawn, their direction (shaders/lightmap.h)
layout(set = 0, binding = 7) uniform samplerBuffer probeTree; // nodes, then cells; read by shaders/probes.glsl
layout(set = 0, binding = 8) uniform samplerBuffer probes;
layout(set = 0, binding = 9, scalar) readonly buffer ProbeStarts
{
    ProbeGrid probeGrid;
    int probeStarts[]; // of each box: a node, or ~cell
};
layout(set = 0, binding = 10, scalar) readonly buffer ReflectionBoxes { ReflectionBox reflectionBoxes[]; };
layout(set = 0, binding = 11) uniform samplerCube reflections[]; // a reflection box each (shaders/reflection.h)
layout(set = 0, binding = 12) uniform sampler2D splitSum;        // over (n.v, roughness): scale and bias of F0
// Bindings 13 and 14: the tables of shaders/layer.h, which declares them.
layout(set = 0, binding = 15, scalar) readonly buffer MediumPlanes { vec4 mediumPlanes[]; };
// Bindings 16 to 21: what rays meet, declared by shaders/trace.glsl.

#endif
