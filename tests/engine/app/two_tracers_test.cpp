// Two tracers, one estimator: the CPU (Embree) and the GPU (ray query) draw the same random numbers for the same paths, so that their pictures
// agree pixel by pixel but where a path took another turn; there they agree within their noise (engine/effects/truth/README.md quotes the
// table).
#include "tests/engine/app/stated_truth.hpp"
#include "tests/engine/app/tracers.hpp"

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

TEST_F(TwoTracers, slowAgreeOnTexturedLevels)
{
    for (const char* name : {"gallery/gallery", "pool/pool"})
        compare(name, loadLevel(std::string("content/") + name + ".glb"), {48, 32}, 8);
}
}
