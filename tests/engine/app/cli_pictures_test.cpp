// The words of the command line for pictures: their size, where they are written, and what draws them.
#include "engine/app/runtime_verbs.hpp"
#include "engine/app/verbs.hpp"
#include "engine/core/file.hpp"
#include "tests/engine/app/asking.hpp"

namespace afterglow
{
// So that what both draw can be compared without a word about sizes.
TEST(CommandLine, draws_and_traces_pictures_of_one_size)
{
    EXPECT_EQ(uvec2(TruthCommand{}.options.size), RenderCommand{}.settings.size);
    EXPECT_EQ(ViewCommand{}.settings.size, RenderCommand{}.settings.size);
    const TruthParameters drawn = RenderCommand{}.settings.truth;
    const TruthOptions traced = TruthCommand{}.options;
    EXPECT_EQ(std::tuple(drawn.samples, drawn.seed, drawn.bounces), std::tuple(uint(traced.samples), traced.seed, uint(traced.bounces)));
}

// Before the level is so much as opened.
TEST(CommandLine, asks_for_the_output_first)
{
    for (const std::vector<const char*>& words : {std::vector{"render", "no.glb", "-o", "/proc/nowhere/a.png"},
                                                  {"render", "no.glb", "-o", "a.png", "--stats", "/proc/nowhere/s.json"},
                                                  {"truth", "no.glb", "-o", "/proc/nowhere/a.exr"},
                                                  {"bake", "no.glb", "-o", "/proc/nowhere/baked"}}) {
        const Answer answer = ask(words);
        EXPECT_EQ(answer.code, 3);
        EXPECT_EQ(answer.err.rfind("afterglow: cannot write /proc/nowhere", 0), 0u) << answer.err;
    }
}

// Nothing is lost, whatever the path is written like; and what takes no place may be named twice.
TEST(CommandLine, writes_no_file_over_another_that_it_names)
{
    const std::filesystem::path in = std::filesystem::path(testing::TempDir()) / "named_twice";
    std::filesystem::remove_all(in);
    std::filesystem::create_directories(in);
    const auto at = [&](const char* name) { return (in / name).string(); };
    std::filesystem::create_symlink("one.png", in / "link.png");
    writeText(in / "one.png", "one");
    writeText(in / "points.json", "points");
    writeText(in / "level.glb", "level");
    const std::string one = at("one.png"), dotted = at("./one.png"), link = at("link.png"), points = at("points.json"),
                      level = at("level.glb"), drawn = at("a.png"), radiance = at("a.exr"), sameRadiance = at("no/../a.exr");
    using Words = std::vector<const char*>;
    const auto refused = [](const Words& words, const std::string& both, const std::string& file) {
        const Answer answer = ask(words);
        EXPECT_EQ(answer.code, 2) << both;
        EXPECT_EQ(answer.err, "afterglow: " + both + " name the same file " + file + "; name another\n");
    };
    refused({"render", "no.glb", "-o", radiance.c_str(), "--layers", sameRadiance.c_str()}, "-o and --layers", sameRadiance);
    refused({"render", "no.glb", "-o", drawn.c_str(), "--stats", drawn.c_str()}, "-o and --stats", drawn);
    refused({"render", "no.glb", "-o", drawn.c_str(), "--layers", radiance.c_str(), "--stats", radiance.c_str()}, "--layers and --stats",
            radiance);
    refused({"render", level.c_str(), "-o", drawn.c_str(), "--stats", level.c_str()}, "LEVEL|DIR and --stats", level);
    refused({"compare", one.c_str(), drawn.c_str(), "-o", dotted.c_str()}, "A and -o", dotted);
    refused({"compare", drawn.c_str(), one.c_str(), "-o", link.c_str()}, "B and -o", link);
    refused({"probe", "no.glb", "--points", points.c_str(), "-o", points.c_str()}, "--points and -o", points);
    EXPECT_EQ(ask({"compare", one.c_str(), one.c_str(), "-o", drawn.c_str()}).code, 3) << "inputs may be the same: it is no picture";
    EXPECT_EQ(ask({"probe", "no.glb", "--points", "/dev/null", "-o", "/dev/null"}).code, 3) << "a device is no file: it holds no points";
    EXPECT_EQ(readText(in / "one.png") + readText(in / "points.json") + readText(in / "level.glb"), "onepointslevel");
}

// What the level has no use for is known once it is read.
TEST(CommandLine, notes_a_knob_of_an_effect_that_is_off)
{
    const char* level = "content/truth/furnace.glb";
    EXPECT_EQ(ask({"plan", level, "--fog-steps", "8"}).err,
              "afterglow: --fog-steps does nothing here: fog is off, no ag_fog_scattering, ag_fog_absorption or ag_fog_emission\n");
    EXPECT_EQ(ask({"plan", level, "--fog-steps", "8", "--effects", "+fog"}).err, "");
    EXPECT_EQ(ask({"plan", level, "--render-scale", "1"}).err, "") << "it is obeyed";
}

// A method that is named turns its effect on.
TEST(CommandLine, says_how_shadows_are_found)
{
    const std::string lit = "content/truth/sun_plane.glb", dark = "content/truth/furnace.glb";
    const auto shadowOf = [](const std::vector<const char*>& words) {
        const std::string out = ask(words).out;
        const std::size_t at = out.find("shadow: ");
        return out.substr(at, out.find('\n', at) - at);
    };
    EXPECT_EQ(shadowOf({"plan", lit.c_str()}), "shadow: on, 1 light whose direct part is drawn here");
    EXPECT_EQ(shadowOf({"plan", lit.c_str(), "--shadows", "ray"}), "shadow: on, 1 light whose direct part is drawn here, by ray query");
    EXPECT_EQ(shadowOf({"plan", dark.c_str(), "--shadows", "ray"}),
              "shadow: on, asked for on the command line; the plan: no punctual light");
    EXPECT_EQ(ask({"plan", lit.c_str(), "--shadows", "stencil"}).code, 2);
}

TEST(CommandLine, says_how_mirrors_are_found)
{
    const auto reflectionOf = [](const std::vector<const char*>& words) {
        const std::string out = ask(words).out;
        const std::size_t at = out.find("reflection: ");
        return out.substr(at, out.find('\n', at) - at);
    };
    const char* level = "content/truth/furnace.glb";
    const std::string off = reflectionOf({"plan", level});
    EXPECT_EQ(off.rfind("reflection: off", 0), 0u);
    EXPECT_EQ(reflectionOf({"plan", level, "--reflections", "auto"}), off);
    for (const char* method : {"screen", "ray"})
        EXPECT_EQ(reflectionOf({"plan", level, "--reflections", method}).rfind("reflection: on, asked for", 0), 0u) << method;
    EXPECT_EQ(ask({"plan", level, "--reflections", "planar"}).code, 2);
}
}
