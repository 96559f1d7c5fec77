// Where things stand: hierarchies in double precision, copies, mirrors, flat and stretched instances.
#include "tests/engine/scene/builder.hpp"
#include <cmath>

namespace afterglow::test
{
using Placement = LevelTest;

const std::vector<float> kIdentityTurn = {0, 0, 0, 1};
const double kHalf = std::sqrt(0.5); // sine and cosine of 45 degrees: a quarter turn as a quaternion

TEST_F(Placement, MultipliesDownTheTree)
{
    // x by 2, then a quarter turn about y (x to -z), then 4 up
    const std::size_t leaf = add("nodes", {{"mesh", mesh(triangle())}, {"scale", {2, 2, 2}}});
    const std::size_t turn = add("nodes", {{"children", {leaf}}, {"rotation", {0, kHalf, 0, kHalf}}});
    node({{"children", {turn}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 4, 0, 1}}});
    const Scene scene = load();
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_TRUE(near(vec3(scene.objects[0].toWorld * dvec4(1, 0, 0, 1)), {0, 4, -2}));
    EXPECT_TRUE(near(scene.lower, {0, 4, -2}, 1e-5f));
    EXPECT_TRUE(near(scene.upper, {0, 6, 0}, 1e-5f));
}

// A million metres out and back: float would be left with steps of 6 cm.
TEST_F(Placement, KeepsDoublePrecision)
{
    const std::size_t leaf = add("nodes", {{"mesh", mesh(triangle())}, {"translation", {-1e6 + 0.001, 0, 0}}});
    node({{"children", {leaf}}, {"translation", {1e6, 0, 0}}});
    EXPECT_NEAR(load().objects[0].toWorld[3].x, 0.001, 1e-9);
}

TEST_F(Placement, SharesAMeshBetweenNodes)
{
    const std::size_t shared = mesh(triangle());
    for (int i = 0; i < 3; ++i) node({{"mesh", shared}, {"translation", {i, 0, 0}}});
    const Scene scene = load();
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(instances(scene).size(), 3u);
    EXPECT_EQ(scene.upper, vec3(3, 1, 0));
}

TEST_F(Placement, PlacesCopies)
{
    const json attributes = {{"TRANSLATION", floats({1, 0, 0, 0, 2, 0}, "VEC3")},
                             {"ROTATION", floats({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4")}, // none, half a turn about z
                             {"SCALE", floats({1, 1, 1, 3, 3, 3}, "VEC3")}};
    place(triangle(), {{"translation", {0, 0, 5}}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
    gltf["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const Scene scene = load();
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_TRUE(near(vec3(scene.objects[0].toWorld * dvec4(1, 0, 0, 1)), {2, 0, 5}));
    EXPECT_TRUE(near(vec3(scene.objects[1].toWorld * dvec4(1, 0, 0, 1)), {-3, 2, 5}));
}

TEST_F(Placement, RefusesMoreCopiesThanCanBeNumbered)
{
    const std::size_t places = add("accessors", {{"componentType", 5126}, {"count", 1ull << 24}, {"type", "VEC3"}});
    place(triangle(), {{"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}});
    EXPECT_NE(sentence().find("16777215 is the most"), std::string::npos);
}

// H19
TEST_F(Placement, SkipsInstancesFlattenedToNothing)
{
    const std::size_t shared = mesh(triangle());
    node({{"mesh", shared}});
    node({{"mesh", shared}, {"scale", {1, 0, 1}}});
    node({{"mesh", shared}, {"scale", {0, 0, 0}}});
    node({{"mesh", shared}, {"scale", {1e-30, 1e-30, 1e-30}}});
    const Scene scene = load();
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(count(scene, "instances flattened to nothing"), 2);
    EXPECT_EQ(count(scene, "instances too small to have an area"), 1);
}

TEST_F(Placement, SkipsInstancesOutOfReach)
{
    const std::size_t shared = mesh(triangle());
    node({{"mesh", shared}, {"translation", {1e19, 0, 0}}});
    const std::size_t child = add("nodes", {{"mesh", shared}, {"scale", {1e12, 1, 1}}});
    node({{"children", {child}}, {"scale", {1e12, 1, 1}}});
    const Scene scene = load();
    EXPECT_TRUE(scene.objects.empty());
    EXPECT_EQ(count(scene, "nodes beyond 1e18 m"), 2);
}

struct Corner {
    vec3 position, normal, tangent, bitangent;
};

// What a renderer makes of an instance, in the order of its indices.
std::vector<Corner> worldCorners(const Scene& scene, const Instance& instance)
{
    std::vector<Corner> corners;
    for (uint i = 0; i < instance.indexCount; ++i) {
        const Vertex& v = scene.vertices[instance.firstVertex + scene.indices[instance.firstIndex + i]];
        Corner corner;
        corner.position = instance.toWorld * vec4(v.position, 1);
        corner.normal = normalize(instance.normalToWorld * v.normal);
        corner.tangent = normalize(mat3(instance.toWorld) * vec3(v.tangent));
        corner.bitangent = cross(corner.normal, corner.tangent) * v.tangent.w;
        corners.push_back(corner);
    }
    return corners;
}

// H20: winding, normal, tangent and bitangent of a mirrored instance are the mirror image of the plain one's.
TEST_F(Placement, MirrorsAnInstanceWithItsHandedness)
{
    json one = triangle();
    one["attributes"]["NORMAL"] = floats({0, 0, 1, 0, 0.6f, 0.8f, 0.6f, 0, 0.8f}, "VEC3");
    one["attributes"]["TANGENT"] = floats({1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1}, "VEC4");
    const std::size_t shared = mesh(one);
    node({{"mesh", shared}});
    node({{"mesh", shared}, {"scale", {-1, 1, 1}}});
    node({{"mesh", shared}, {"scale", {-2, -2, -2}}});
    const Scene scene = load();
    const std::vector<Instance> all = instances(scene);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 2u); // the plain one and one mirror image, shared
    for (const Object& object : scene.objects) EXPECT_GT(determinant(dmat3(object.toWorld)), 0.0);

    const auto plain = worldCorners(scene, all[0]);
    for (std::size_t i : {1, 2}) {
        auto mirrored = worldCorners(scene, all[i]);
        const vec3 face = normalize(cross(mirrored[1].position - mirrored[0].position, mirrored[2].position - mirrored[0].position));
        const vec3 mirror = i == 1 ? vec3(-1, 1, 1) : vec3(-1, -1, -1);
        EXPECT_TRUE(near(face, vec3(0, 0, 1) * mirror)); // the front stays the front
        std::swap(mirrored[1], mirrored[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_TRUE(near(mirrored[c].position, plain[c].position * mirror * (i == 1 ? 1.0f : 2.0f)));
            EXPECT_TRUE(near(mirrored[c].normal, plain[c].normal * mirror));
            EXPECT_TRUE(near(mirrored[c].tangent, plain[c].tangent * mirror));
            EXPECT_TRUE(near(mirrored[c].bitangent, plain[c].bitangent * mirror));
        }
    }
}

// H21: normals stay perpendicular to the surface under 1 : 1000, for triangles that lean every way.
TEST_F(Placement, KeepsNormalsPerpendicularUnderStretching)
{
    std::vector<float> positions;
    for (int i = 0; i < 200; ++i) {
        const float a = 0.1f * float(i), b = 0.37f * float(i);
        positions.insert(positions.end(), {0, 0, 0, std::cos(a), std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::sin(b),
                                           std::cos(a) * std::cos(b), -std::cos(a) * std::sin(b) + 0.1f});
    }
    const std::size_t shared = mesh(primitive(positions));
    for (const json& scale : {json{1, 1000, 1}, json{1000, 1, 1000}, json{0.001, 1, 1}, json{1e-6, 1e-3, 1}})
        node({{"mesh", shared}, {"scale", scale}, {"rotation", {0.1, 0.2, 0.3, 0.927}}});
    const Scene scene = load();
    float worst = 0.0f;
    for (const Instance& instance : instances(scene)) {
        const dmat3 linear(scene.objects[instance.object].toWorld);
        for (uint i = 0; i < instance.indexCount; i += 3) {
            dvec3 p[3];
            for (uint c = 0; c < 3; ++c)
                p[c] = dvec3(scene.vertices[instance.firstVertex + scene.indices[instance.firstIndex + i + c]].position);
            const vec3 normal =
                normalize(instance.normalToWorld * scene.vertices[instance.firstVertex + scene.indices[instance.firstIndex + i]].normal);
            for (const dvec3& edge : {p[1] - p[0], p[2] - p[0], p[2] - p[1]})
                worst = std::max(worst, float(std::abs(dot(dvec3(normal), normalize(linear * edge)))));
            // and the front stays the front
            EXPECT_GT(dot(dvec3(normal), cross(linear * (p[1] - p[0]), linear * (p[2] - p[0]))), 0.0);
        }
    }
    EXPECT_LT(worst, 1e-5f);
}

TEST_F(Placement, VisitsANodeWithTwoParentsOnceAndLeavesCircles)
{
    const std::size_t leaf = add("nodes", {{"mesh", mesh(triangle())}});
    const std::size_t circle = node({{"children", {leaf}}});
    node({{"children", {leaf, circle}}});
    gltf["nodes"][leaf]["children"] = {circle};
    const Scene scene = load();
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(count(scene, "nodes met twice"), 3);
}

TEST_F(Placement, TakesEveryRootWhereThereIsNoScene)
{
    place(triangle());
    gltf.erase("scene");
    gltf.erase("scenes");
    EXPECT_EQ(load().objects.size(), 1u);
}
}
