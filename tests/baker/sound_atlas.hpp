// What holds of every atlas.
#pragma once
#include "baker/atlas.hpp"
#include "tests/baker/atlas_audit.hpp"
#include "tests/baker/shapes.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
inline double area(const Scene& scene) // of all static objects, m2
{
    double sum = 0;
    for (const Object& object : scene.objects)
        for (const Primitive& p : scene.meshes[object.mesh].primitives)
            for (uint i = 0; object.isStatic && i < p.indexCount; i += 3) {
                dvec3 c[3];
                for (uint k = 0; k < 3; ++k)
                    c[k] = dvec3(object.toWorld *
                                 dvec4(dvec3(scene.vertices[p.firstVertex + scene.indices[p.firstIndex + i + k]].position), 1.0));
                sum += length(cross(c[1] - c[0], c[2] - c[0])) / 2;
            }
    return sum;
}

// Every triangle has a place, its own, and no bilinear lookup reaches the texels of another chart.
inline AtlasAudit expectSound(Scene& scene, const AtlasOptions& options, Atlas& atlas)
{
    double before = area(scene);
    std::size_t triangles = scene.indices.size();
    atlas = makeAtlas(scene, options);
    AtlasAudit audit = auditAtlas(scene, atlas);
    EXPECT_EQ(scene.indices.size(), triangles);
    EXPECT_NEAR(audit.area, before, 1e-6 * before);
    EXPECT_EQ(audit.sharedTexels, 0);
    EXPECT_EQ(audit.folded, 0);
    EXPECT_EQ(audit.outside, 0);
    EXPECT_EQ(audit.flipped, 0);
    EXPECT_EQ(audit.unlit, 0);
    EXPECT_EQ(atlas.places.size(), scene.objects.size());
    for (const ivec2& size : atlas.pageSizes) {
        EXPECT_EQ(size.x % 8, 0);
        EXPECT_EQ(size.y % 8, 0);
    }
    return audit;
}

inline AtlasAudit expectSound(const Shape& shape, const AtlasOptions& options, Atlas& atlas)
{
    Scene scene = levelOf(shape);
    return expectSound(scene, options, atlas);
}
}
