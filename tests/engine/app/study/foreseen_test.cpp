// What is said before a bake is what is found after it.
#include "baker/baker.hpp"
#include "engine/app/study/foreseen.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
TEST(Foreseen, is_the_plan_of_the_bake_that_follows)
{
    for (const char* name : {"truth/furnace", "truth/nothing", "truth/sun_plane", "truth/fog_room", "truth/mirror_corridor", "truth/portal",
                             "hanging_cube/hanging_cube"}) {
        const Scene level = loadLevel(std::string("content/") + name + ".glb");
        const Settings settings = adoptLevel({}, level);
        BakeOptions options;
        options.quality = Quality::draft, options.texelsPerMetre = 1.0f;
        options.samples = options.probeSamples = options.reflectionSamples = 1, options.reflectionSize = 8, options.probeSpacing = 2.0f;
        Progress progress(ProgressStyle::none);
        nlohmann::json unasked;
        const Baked bake = bakeScene(level, options, progress, unasked);
        const Plan found = plan(needs(level), evidenceOf(bake.scene, &bake, settings), {}), foreseen = foreseenPlan(level, settings);
        ASSERT_EQ(foreseen.effects.size(), found.effects.size());
        for (std::size_t i = 0; i < found.effects.size(); ++i)
            EXPECT_EQ(foreseen.effects[i].on, found.effects[i].on)
                << name << ", " << found.effects[i].effect << ": " << found.effects[i].reason;
    }
}
}
