// Two tracers, one estimator: the CPU (Embree) and the GPU (ray query) draw the same random numbers for the same paths, so that their
// pictures agree pixel by pixel but where a path took another turn; there they agree within their noise (engine/effects/truth/README.md
// quotes the table).
#include "tests/engine/app/stated_truth.hpp"
#include "tests/engine/app/tracers.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
class TwoTracers : public Tracers
{
protected:
    static constexpr double kOfTwoCompilers = 0.97; // what one rounds otherwise turns a path off at an edge

    void compare(const std::string& name, const Scene& scene, uvec2 size, uint samples)
    {
        const TruthOptions picture = pictureOf(scene, "", ivec2(size), int(samples));
        expectAgreement(name, picture, onGpu(scene, picture), byEmbree(scene, picture), kOfTwoCompilers);
    }
};

TEST_F(TwoTracers, AgreeOnEveryLevelWhoseAnswerIsKnown)
{
    for (const std::string& name : levelsOfKnownAnswer()) compare(name, loadLevel(kKnownAnswers / (name + ".glb")), {24, 24}, 4);
}

TEST_F(TwoTracers, AgreeOnRooms)
{
    for (const char* name : {"cornell/cornell", "two_rooms/two_rooms_open", "two_rooms/two_rooms_closed", "hanging_cube/hanging_cube",
                             "still_life/still_life"})
        compare(name, loadLevel(std::string("content/") + name + ".glb"), {32, 32}, 4);
}

// Texels are decoded, then filtered, as glTF asks: halfway between black and white lies half of the light, not what half of the code stands
// for.
TEST_F(TwoTracers, FilterTheLightOfTexels)
{
    Scene scene;
    SceneTexture texture;
    texture.image.width = 2, texture.image.height = 1;
    texture.image.pixels = {0, 0, 0, 255, 255, 255, 255, 255};
    texture.srgb = true;
    texture.wrapU = texture.wrapV = Wrap::clamp;
    scene.textures.push_back(texture);
    Material lamp = matte(vec3(0.0f));
    lamp.emission = vec3(1.0f);
    lamp.emissiveTexture.texture = 0;
    addQuad(scene, vec3(-1, -1, -1), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, lamp));
    TruthOptions middle{.camera = lookAt(vec3(0), vec3(0, 0, -1)), .size = ivec2(4), .samples = 1};
    middle.camera.fovY = 0.0f;
    middle.camera.orthoHeight = 1e-4f; // of 2 m: the light changes by no more along it
    for (const Image& image : {byEmbree(scene, middle), onGpu(scene, middle)}) EXPECT_NEAR(image.at(1, 1)[1], 0.5f, 1e-4f);
}

TEST_F(TwoTracers, slowAgreeOnTexturedLevels)
{
    for (const char* name : {"gallery/gallery", "pool/pool"})
        compare(name, loadLevel(std::string("content/") + name + ".glb"), {48, 32}, 8);
}
}
