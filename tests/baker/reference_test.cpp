// The path tracer through portals; against levels that carry their own answer in tests/engine/app/stated_truth_test.cpp.
#include "baker/baker.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
// As in the runtime: the bent lamp, a second material of the portal's own mesh, is no portal.
TEST(Truth, OfAnObjectOfSeveralMaterialsWhatIsFlatIsAPortal)
{
    Scene scene;
    Material lamp = matte(vec3(0.0f));
    lamp.emission = vec3(1.0f);
    const uint door = addMaterial(scene, matte(vec3(0.5f))), bent = addMaterial(scene, lamp);
    Object& a = addQuad(scene, vec3(-3, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), door);
    a.name = std::string("A"), a.portal = std::string("B");
    addQuad(scene, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), bent);
    scene.vertices.back().position.z = -0.3f;
    scene.meshes[0].primitives.push_back(scene.meshes[1].primitives[0]);
    scene.objects.pop_back();
    Object& b = addQuad(scene, vec3(-3, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), door);
    b.name = std::string("B"), b.portal = std::string("A"), b.toWorld[3] = dvec4(50, 0, 0, 1);
    TruthOptions options;
    options.size = ivec2(8, 8);
    options.samples = 4;
    options.portalDepth = 1;
    options.camera = lookAt(vec3(0, 0, 4), vec3(0), 0.2f);
    Progress silent(ProgressStyle::none);
    EXPECT_EQ(truth(scene, options, silent).at(4, 4)[0], 1.0f);
}
}
