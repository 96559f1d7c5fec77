// What is turned on a device with ray queries, with ray programs alone, and with neither; and for how long it works before it is timed.
#include "engine/app/study/choice.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
struct Choice {
    std::vector<Sweep> sweeps;
    std::vector<std::string> absent;
    const Sweep* of(const std::string& knob) const
    {
        const auto found = std::find_if(sweeps.begin(), sweeps.end(), [&](const Sweep& sweep) { return sweep.knob == knob; });
        return found == sweeps.end() ? nullptr : &*found;
    }
    bool tells(const std::string& line) const { return std::find(absent.begin(), absent.end(), line) != absent.end(); }
};

Choice chosen(const std::string& subject, const Device& device)
{
    StudyCommand command;
    command.effects = {subject};
    Choice choice;
    choice.sweeps = sweepsOf(subject, device, /* drawn= */ false, command, choice.absent);
    for (const Sweep& sweep : choice.sweeps) EXPECT_FALSE(sweep.values.empty()) << sweep.knob << " has nothing to turn";
    return choice;
}

Device deviceWith(bool queries, bool programs)
{
    DeviceOptions options = deviceOptions("");
    options.rayQuery = queries, options.rayPipeline = programs;
    return Device(options);
}
}

TEST(Chosen, IsWhatTheDeviceCan)
{
    const Device both = deviceWith(true, true), programs = deviceWith(false, true), neither = deviceWith(false, false);
    const std::string name = neither.deviceName;
    const auto cannot = [&](const std::string& way) { return "truth by tracing " + way + ": " + name + " cannot"; };
    const std::string noRays = "occlusion by rays: " + name + " has no ray queries";

    const Choice none = chosen("truth", neither);
    EXPECT_EQ(none.of("tracing"), nullptr) << "no value is left of it";
    EXPECT_NE(none.of("paths"), nullptr) << "the CPU traces";
    for (const char* way : {"kernel", "pipeline", "wavefront"}) EXPECT_TRUE(none.tells(cannot(way))) << way;
    const Choice contact = chosen("occlusion", neither);
    EXPECT_EQ(contact.of("rays"), nullptr);
    EXPECT_TRUE(contact.tells(noRays));
    EXPECT_NE(contact.of("hbao steps"), nullptr) << "asks no ray";

    if (programs.rayPipeline) {
        const Choice one = chosen("truth", programs);
        ASSERT_NE(one.of("tracing"), nullptr);
        EXPECT_EQ(one.of("tracing")->names, std::vector<std::string>{"pipeline"});
        EXPECT_TRUE(one.tells(cannot("kernel")) && one.tells(cannot("wavefront")) && !one.tells(cannot("pipeline")));
        EXPECT_TRUE(chosen("occlusion", programs).tells(noRays)) << "contact asks queries";
    }
    if (both.rayQuery && both.rayPipeline) {
        const Choice all = chosen("truth", both);
        ASSERT_NE(all.of("tracing"), nullptr);
        EXPECT_EQ(all.of("tracing")->values.size(), 3u);
        EXPECT_TRUE(all.absent.empty());
        EXPECT_TRUE(chosen("occlusion", both).absent.empty());
    }
}

// A level that mirrors, in whose bake no cubemap stands: what is read off a cubemap is not studied, whoever asks, and the reason is told.
TEST(Chosen, IsNothingOfCubemapsWhereNoneStands)
{
    const Scene level = loadLevel("content/truth/mirror_corridor.glb");
    ASSERT_TRUE(need(needs(level), "reflections").on);
    Baked bake;
    bake.scene = level;
    bake.places.resize(level.objects.size());
    const Plan planned = plan(needs(level), evidenceOf(bake.scene, &bake, {}), {});
    StudyCommand command;
    command.effects = {"roulette", "reflections", "harmonics", "split sum"};
    std::vector<std::string> absent;
    EXPECT_EQ(studied(command, planned, absent), std::vector<std::string>{"roulette"});
    EXPECT_EQ(absent, (std::vector<std::string>{"reflections: off, the bake holds none", "harmonics: off, the bake holds none",
                                                "split sum: off, the bake holds none"}));
    command.effects = {"split sum"};
    EXPECT_THROW(studied(command, planned, absent), Error);
}

// Frames of so many ms until one is timed.
static int untimedFrames(double ms)
{
    Sitting sitting;
    int frames = 0;
    for (; sitting.next == Sitting::kFirst; ++frames) ++sitting.next, warmUp(sitting, ms);
    EXPECT_EQ(sitting.next, 0) << "the first that is timed";
    return frames;
}

TEST(Sitting, warms_up_until_its_time_is_over)
{
    EXPECT_EQ(untimedFrames(Sitting::kWarmMs), 1);
    EXPECT_EQ(untimedFrames(0.45 * Sitting::kWarmMs), 3);
    EXPECT_EQ(untimedFrames(10.0 * Sitting::kWarmMs), 1) << "the frame that compiles";
    EXPECT_EQ(untimedFrames(0.0), 400) << "a device without a clock";
}
}
