#include "engine/baked/scene_glb.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/scene/document.hpp"
#include "tests/engine/baked/level.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
// All of the level by so many metres along each axis.
static void moveRoots(const std::filesystem::path& path, double by)
{
    nlohmann::json level = nlohmann::json::parse(readText(path));
    for (const nlohmann::json& root : level["scenes"][0]["nodes"]) {
        nlohmann::json& node = level["nodes"][root.get<std::size_t>()];
        if (!node.contains("translation")) node["translation"] = {0.0, 0.0, 0.0};
        for (nlohmann::json& coordinate : node["translation"]) coordinate = coordinate.get<double>() + by;
    }
    writeText(path, level.dump());
}

// The level with an atlas as a baker would give it: the triangles of each primitive split from each other, uv1 all over, and the vertices
// in an order that no import would choose.
static Baked bakedLevel(const std::filesystem::path& folder, double movedBy = 0.0)
{
    Baked baked;
    const std::filesystem::path level = LevelFile().write(folder);
    if (movedBy != 0.0) moveRoots(level, movedBy);
    baked.scene = loadLevel(level);
    Scene& scene = baked.scene;
    std::vector<Vertex> vertices;
    for (Mesh& mesh : scene.meshes) {
        for (Primitive& primitive : mesh.primitives) {
            const uint first = uint(vertices.size());
            for (uint i = 0; i < primitive.indexCount; ++i) {
                const uint reversed = primitive.indexCount - 1 - i;
                vertices.push_back(scene.vertices[primitive.firstVertex + scene.indices[primitive.firstIndex + reversed]]);
                vertices.back().uv1 = vec2(float(i) / 7.0f, 1.0f / (1.0f + float(i)));
            }
            for (uint i = 0; i < primitive.indexCount; ++i) scene.indices[primitive.firstIndex + i] = primitive.indexCount - 1 - i;
            primitive.firstVertex = first;
            primitive.vertexCount = primitive.indexCount;
        }
    }
    scene.vertices = vertices;
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        baked.places.push_back({o == 2 ? -1 : 0, vec2(0.5f + float(o), 0.1f), vec2(0.125f, 1.0f / 3.0f)});
    for (const Mesh& mesh : scene.meshes) {
        MeshLods& lods = baked.lods.emplace_back();
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
            lods.primitives.push_back({{{0, 1, 2}, 0.1f, 0.2f}, {{3, 4, 5}, 0.3f, 0.4f}});
    }
    return baked;
}

static Baked written(const Baked& baked, const std::filesystem::path& folder)
{
    const SceneFiles files = writeScene(baked);
    writeFile(folder / "scene.glb", files.glb.data(), files.glb.size());
    if (!files.skyName.empty()) writeFile(folder / files.skyName, files.sky.data(), files.sky.size());
    Baked back;
    readScene(folder / "scene.glb", back);
    return back;
}

static void expectNear(vec3 a, vec3 b)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-6f);
}

// Corner by corner: where a vertex is stored is the file's affair.
static void expectSameTriangles(const Scene& a, const Scene& b)
{
    const std::vector<Instance> first = instances(a), second = instances(b);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        ASSERT_EQ(first[i].indexCount, second[i].indexCount);
        EXPECT_EQ(a.objects[first[i].object].name, b.objects[second[i].object].name);
        EXPECT_EQ(first[i].material, second[i].material);
        EXPECT_EQ(first[i].flags, second[i].flags);
        for (uint k = 0; k < first[i].indexCount; ++k) {
            const Vertex& v = a.vertices[first[i].firstVertex + a.indices[first[i].firstIndex + k]];
            const Vertex& w = b.vertices[second[i].firstVertex + b.indices[second[i].firstIndex + k]];
            expectNear(first[i].toWorld * vec4(v.position, 1.0f), second[i].toWorld * vec4(w.position, 1.0f));
            expectNear(first[i].normalToWorld * v.normal, second[i].normalToWorld * w.normal);
            EXPECT_EQ(v.position, w.position);
            EXPECT_EQ(v.uv0, w.uv0);
            EXPECT_EQ(v.uv1, w.uv1);
            EXPECT_EQ(v.color, w.color);
            if (a.materials[first[i].material].normalTexture.texture < 0) continue; // arbitrary tangents, which nobody reads
            for (int c = 0; c < 4; ++c) EXPECT_NEAR(v.tangent[c], w.tangent[c], 1e-6f);
        }
    }
}

TEST(SceneGlb, loads_to_the_same_triangles_materials_lights_cameras_and_media)
{
    const std::filesystem::path folder = emptyFolder("scene_same");
    const Baked in = bakedLevel(folder), out = written(in, folder);
    const Scene &a = in.scene, &b = out.scene;
    ASSERT_EQ(a.objects.size(), 6u); // child, twin, mirrored, three of the row
    expectSameTriangles(a, b);
    for (std::size_t o = 0; o < a.objects.size(); ++o) {
        EXPECT_EQ(a.objects[o].isStatic, b.objects[o].isStatic);
        EXPECT_EQ(a.objects[o].texelsPerMetre, b.objects[o].texelsPerMetre);
    }
    ASSERT_EQ(a.materials.size(), b.materials.size());
    EXPECT_EQ(a.materialNames, b.materialNames);
    EXPECT_EQ(a.materials[0].sigma, b.materials[0].sigma);
    EXPECT_EQ(a.materials[0].roughness, b.materials[0].roughness);
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t t = 0; t < a.textures.size(); ++t) EXPECT_EQ(a.textures[t].image.pixels, b.textures[t].image.pixels);
    ASSERT_EQ(b.lights.size(), 1u);
    expectNear(a.lights[0].position, b.lights[0].position);
    EXPECT_EQ(a.lights[0].intensity, b.lights[0].intensity);
    EXPECT_EQ(a.lights[0].radius, b.lights[0].radius);
    ASSERT_EQ(b.cameras.size(), 1u);
    EXPECT_EQ(a.cameras[0].name, b.cameras[0].name);
    EXPECT_EQ(a.cameras[0].toWorld, b.cameras[0].toWorld);
    ASSERT_EQ(b.media.size(), 1u);
    EXPECT_EQ(a.media[0].upper, b.media[0].upper);
    EXPECT_EQ(a.sky.image.pixels, b.sky.image.pixels);
    EXPECT_EQ(a.display.exposureEv, b.display.exposureEv);
    EXPECT_EQ(a.warnings, b.warnings);
}

// H10: the file speaks the level's own coordinates, and loads to the same rebased scene.
TEST(SceneGlb, of_a_level_far_out_loads_to_the_same_scene)
{
    const std::filesystem::path folder = emptyFolder("scene_far");
    const Baked in = bakedLevel(folder, 1e6), out = written(in, folder);
    EXPECT_GT(in.scene.origin.x, 9e5);
    EXPECT_EQ(in.scene.origin, out.scene.origin);
    expectSameTriangles(in.scene, out.scene);
    expectNear(in.scene.lights[0].position, out.scene.lights[0].position);
    EXPECT_EQ(in.scene.cameras[0].toWorld, out.scene.cameras[0].toWorld);
    EXPECT_EQ(in.scene.media[0].upper, out.scene.media[0].upper);
    const Document document = openDocument(folder / "scene.glb");
    for (const nlohmann::json& root : document.json->at("scenes")[0]["nodes"])
        EXPECT_GT(document.json->at("nodes")[root.get<std::size_t>()]["translation"][1].get<double>(), 9e5);
}

TEST(SceneGlb, keeps_places_and_levels_of_detail)
{
    const std::filesystem::path folder = emptyFolder("scene_places");
    const Baked in = bakedLevel(folder), out = written(in, folder);
    ASSERT_EQ(in.places.size(), out.places.size());
    for (std::size_t o = 0; o < in.places.size(); ++o) {
        EXPECT_EQ(in.places[o].page, out.places[o].page);
        if (in.places[o].page < 0) continue;
        EXPECT_EQ(in.places[o].scale, out.places[o].scale);
        EXPECT_EQ(in.places[o].offset, out.places[o].offset);
    }
    ASSERT_EQ(in.lods.size(), out.lods.size());
    for (std::size_t m = 0; m < in.lods.size(); ++m) {
        ASSERT_EQ(in.lods[m].primitives.size(), out.lods[m].primitives.size());
        for (std::size_t p = 0; p < in.lods[m].primitives.size(); ++p) {
            ASSERT_EQ(out.lods[m].primitives[p].size(), 2u);
            for (std::size_t level = 0; level < 2; ++level) {
                const LodLevel &a = in.lods[m].primitives[p][level], &b = out.lods[m].primitives[p][level];
                EXPECT_EQ(a.error, b.error);
                EXPECT_EQ(a.turn, b.turn);
                ASSERT_EQ(a.indices.size(), b.indices.size());
                for (std::size_t k = 0; k < a.indices.size(); ++k) {
                    const Vertex& v = in.scene.vertices[in.scene.meshes[m].primitives[p].firstVertex + a.indices[k]];
                    const Vertex& w = out.scene.vertices[out.scene.meshes[m].primitives[p].firstVertex + b.indices[k]];
                    EXPECT_EQ(v.position, w.position);
                    EXPECT_EQ(v.uv1, w.uv1);
                }
            }
        }
    }
}

TEST(SceneGlb, keeps_what_only_the_file_knows)
{
    const std::filesystem::path folder = emptyFolder("scene_file");
    const SceneFiles files = writeScene(bakedLevel(folder));
    const std::string text(files.glb.begin() + 20, files.glb.begin() + 20 + get32(&files.glb[12]));
    const nlohmann::json gltf = nlohmann::json::parse(text);
    EXPECT_EQ(gltf["asset"]["copyright"], "a test");
    EXPECT_EQ(gltf["nodes"][1]["extras"]["colour"], "red");
    EXPECT_EQ(gltf["nodes"][0]["children"], nlohmann::json({1, 2}));
    EXPECT_EQ(gltf["meshes"][0]["extras"]["author"], "me");
    EXPECT_EQ(gltf["animations"].size(), 1u);
    EXPECT_EQ(gltf["images"][0].count("uri"), 0u);
    EXPECT_EQ(gltf["buffers"].size(), 1u);
    EXPECT_EQ(gltf["extensionsUsed"], nlohmann::json({"KHR_lights_punctual", "MSFT_lod"}));
    EXPECT_EQ(get32(&files.glb[8]), files.glb.size());
    EXPECT_EQ(files.glb.size() % 4, 0u);
}

TEST(SceneGlb, written_again_is_the_same_file)
{
    const std::filesystem::path folder = emptyFolder("scene_twice");
    const Baked in = bakedLevel(folder);
    EXPECT_EQ(writeScene(in).glb, writeScene(in).glb);
    std::filesystem::create_directories(folder / "again");
    Baked once = written(in, folder); // its path is scene.glb now: a bake can be baked
    const Baked twice = written(once, folder / "again");
    expectSameTriangles(once.scene, twice.scene);
}

// The atlas takes TEXCOORD_1, so a texture that read it reads TEXCOORD_0 in the baked file; and a picture that is not there looks the same.
TEST(SceneGlb, keeps_textures_of_the_second_coordinates_and_missing_ones)
{
    const std::filesystem::path folder = emptyFolder("scene_second_uv");
    const std::filesystem::path file = LevelFile().write(folder);
    nlohmann::json gltf = nlohmann::json::parse(readText(file));
    for (nlohmann::json& mesh : gltf["meshes"]) {
        nlohmann::json& attributes = mesh["primitives"][0]["attributes"];
        attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
        attributes.erase("TEXCOORD_0");
    }
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    gltf["materials"][0]["normalTexture"]["texCoord"] = 1;
    gltf["images"][0]["uri"] = "nowhere.png";
    writeText(file, gltf.dump());

    Baked in;
    in.scene = loadLevel(file);
    const std::vector<vec2> shown = {in.scene.vertices[1].uv0, in.scene.vertices[2].uv0};
    ASSERT_EQ(shown, (std::vector<vec2>{{1, 1}, {1, 0}}));
    for (Vertex& vertex : in.scene.vertices) vertex.uv1 = vec2(0.5f); // the atlas
    in.places.resize(in.scene.objects.size());
    in.lods.resize(in.scene.meshes.size());
    for (std::size_t m = 0; m < in.lods.size(); ++m) in.lods[m].primitives.resize(in.scene.meshes[m].primitives.size());
    const Baked out = written(in, folder);
    expectSameTriangles(in.scene, out.scene);
    const TextureRef &before = in.scene.materials[0].baseColorTexture, &after = out.scene.materials[0].baseColorTexture;
    EXPECT_EQ(after.uvSet, 0u);
    EXPECT_EQ(texel(out.scene.textures[after.texture], 0, 0), texel(in.scene.textures[before.texture], 0, 0));
}

// A bake of an earlier version does not say how far normals turn: said once, however many meshes it has.
TEST(SceneGlb, says_that_levels_of_detail_without_turns_are_not_drawn)
{
    const std::filesystem::path folder = emptyFolder("scene_mute");
    SceneFiles files = writeScene(bakedLevel(folder));
    const auto read = [&] {
        writeFile(folder / "scene.glb", files.glb.data(), files.glb.size());
        Baked back;
        readScene(folder / "scene.glb", back);
        return back;
    };
    const std::size_t before = read().scene.warnings.size();
    const std::string key = "ag_lod_turn";
    int renamed = 0;
    for (auto at = files.glb.begin(); (at = std::search(at, files.glb.end(), key.begin(), key.end())) != files.glb.end(); ++at, ++renamed)
        at[0] = 'x';
    EXPECT_GT(renamed, 1);
    const Baked mute = read();
    ASSERT_EQ(mute.scene.warnings.size(), before + 1);
    EXPECT_NE(mute.scene.warnings.back().find("bake it again"), std::string::npos);
    EXPECT_EQ(mute.lods.at(0).primitives.at(0).at(0).turn, kPi);
}

TEST(SceneGlb, of_a_level_that_is_gone_cannot_be_written)
{
    const std::filesystem::path folder = emptyFolder("scene_gone");
    const Baked in = bakedLevel(folder);
    std::filesystem::remove(folder / "level.gltf");
    EXPECT_THROW(writeScene(in), Error);
}
}
