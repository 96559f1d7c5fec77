// The words of the command line: what is said, and the exit code.
#include "engine/core/file.hpp"
#include "tests/engine/app/asking.hpp"
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

namespace afterglow
{
TEST(CommandLine, says_its_version)
{
    const Answer answer = ask({"--version"});
    EXPECT_EQ(answer.code, 0);
    EXPECT_EQ(answer.out, "afterglow " AFTERGLOW_VERSION "\n");
}

TEST(CommandLine, names_what_it_does_not_know_in_its_order)
{
    const Answer answer = ask({"render", "level", "-o", "a.png", "--wires", "thin"});
    EXPECT_EQ(answer.code, 2);
    EXPECT_EQ(answer.err, "afterglow: render: not expected: --wires thin; see `afterglow render --help`\n");
}

TEST(CommandLine, says_which_occlusion_there_is)
{
    const Answer none = ask({"plan", "no.glb", "--ao", "nothing"});
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.err.find("--ao"), std::string::npos) << none.err;
    for (const char* method : {"ssao", "hbao", "voxel", "ray", "auto"})
        EXPECT_EQ(ask({"plan", "no.glb", "--ao", method}).code, 3) << method << ": there is no such file";
    EXPECT_EQ(ask({"plan", "no.glb", "--ao", "hbao", "--ao-range", "0"}).code, 2);
}

TEST(CommandLine, names_an_option_before_the_verb_that_it_does_not_know)
{
    const Answer answer = ask({"--foo"});
    EXPECT_EQ(answer.code, 2);
    EXPECT_NE(answer.err.find("--foo"), std::string::npos) << answer.err;
}

// NaN is within no range, a size is two plain numbers, an output has a name and the right ending: all before any work.
TEST(CommandLine, takes_no_number_or_name_that_is_none)
{
    for (const std::vector<const char*>& words : {std::vector{"bake", "no.glb", "-o", "x", "--texels-per-metre", "nan"},
                                                  {"bake", "no.glb", "-o", "x", "--texels-per-metre", "1e999"},
                                                  {"bake", "no.glb", "-o", ""},
                                                  {"bake", "no.glb", "-o", "x", "--target-error", "0"},
                                                  {"bake", "no.glb", "-o", "x", "--target-error", "0.1", "--samples", "8"},
                                                  {"truth", "no.glb", "-o", "x.exr", "--ao-range", "nan"},
                                                  {"truth", "no.glb", "-o", "x.exr", "--ao-range", "0"},
                                                  {"truth", "no.glb", "-o", "x.exr", "--size", "+8x8"},
                                                  {"truth", "no.glb", "-o", "x.exr", "--size", "8x 8"},
                                                  {"truth", "no.glb", "-o", "x.exr", "--size", "4294967304x8"},
                                                  {"truth", "no.glb", "-o", ""},
                                                  {"truth", "no.glb", "-o", "x.png"},
                                                  {"render", "no.glb", "-o", "x.png", "--layers", "x.png"},
                                                  {"render", "no.glb", "-o", "x.png", "--effects", "fog,,"},
                                                  {"render", "no.glb", "-o", "x.png", "--mode", "true"},
                                                  {"render", "no.glb", "-o", "x.png", "--samples", "0"},
                                                  {"render", "no.glb", "-o", "x.png", "--samples", "8"}, // of no truth
                                                  {"render", "no.glb", "-o", "x.png", "--tracing", "pipeline"},
                                                  {"render", "no.glb", "-o", "x.png", "--mode", "truth", "--tracing", "fast"},
                                                  {"render", "no.glb", "-o", "x.png", "--mode", "truth", "--frames", "2"},
                                                  {"render", "no.glb", "-o", "x.png", "--mode", "truth", "--layers", "x.exr"},
                                                  {"compare", "a.exr", "b.exr", "-o", "x.jpg"}}) {
        const Answer answer = ask(words);
        EXPECT_EQ(answer.code, 2) << answer.err;
        EXPECT_LT(answer.err.size(), 160u) << answer.err;
    }
    EXPECT_EQ(ask({"truth", "no.glb", "-o", "x.EXR"}).code, 3); // capitals are an ending: only the level is missing
}

// What is wrong with it, and what is right, in the words of whoever typed it.
TEST(CommandLine, says_what_a_size_and_a_seed_are)
{
    for (const auto& [word, least] : {std::pair{"--max-memory", "1M"}, {"--probe-budget", "1K"}}) {
        for (const char* size : {"-1G", "5X", "1", "0", "1.5G", "99999999999G"})
            EXPECT_EQ(ask({"bake", "no.glb", "-o", "x", word, size}).err,
                      "afterglow: " + std::string(word) + ": '" + size + "' is not a size of " + least +
                          " or more, such as 512M or 2G; a number alone is bytes; see `afterglow bake --help`\n");
        for (const char* size : {"1048576", "1M", "512m", "2G", "2 GiB"})
            EXPECT_EQ(ask({"bake", "no.glb", "-o", "x", word, size}).code, 3) << size << ": only the level is missing";
    }
    using Words = std::vector<const char*>;
    for (const Words& verb :
         {Words{"bake", "no.glb", "-o", "x"}, {"truth", "no.glb", "-o", "x.exr"}, {"render", "no.glb", "-o", "x.png", "--mode", "truth"}})
        for (const char* seed : {"-4", "1.5", "4294967296", "first"}) {
            Words words = verb;
            words.insert(words.end(), {"--seed", seed});
            EXPECT_EQ(ask(words).err, "afterglow: --seed: '" + std::string(seed) +
                                          "' is not a whole number from 0 to 4294967295; see `afterglow " + verb[0] + " --help`\n");
        }
}

TEST(CommandLine, says_what_is_no_whole_number)
{
    for (const char* text : {"abc", "0", "1.5", "99999999999", "12x"})
        EXPECT_EQ(ask({"bake", "no.glb", "-o", "x", "--samples", text}).err,
                  "afterglow: --samples: '" + std::string(text) +
                      "' is not a whole number from 1 to 16777216; see `afterglow bake --help`\n");
    for (const char* text : {"16777216", "010", "08"})
        EXPECT_EQ(ask({"bake", "no.glb", "-o", "x", "--samples", text}).code, 3) << text << ": only the level is missing";
}

TEST(CommandLine, takes_one_list_of_products_and_then_the_level)
{
    EXPECT_EQ(ask({"bake", "--only", "lods,voxels", "no.glb", "-o", "x"}).code, 3) << "only the level is missing";
}

// Each says beside which other it is in vain, before the level is so much as opened.
TEST(CommandLine, refuses_words_that_would_do_nothing)
{
    using Words = std::vector<const char*>;
    const auto refused = [](Words words, const Words& more, const std::string& sentence) {
        const std::string verb = words.front();
        words.insert(words.end(), more.begin(), more.end());
        const Answer answer = ask(words);
        EXPECT_EQ(answer.code, 2) << sentence;
        EXPECT_EQ(answer.err, "afterglow: " + sentence + "; see `afterglow " + verb + " --help`\n");
    };
    const Words truth = {"truth", "no.glb", "-o", "x.exr"}, traced = {"render", "no.glb", "-o", "x.png", "--mode", "truth"},
                bake = {"bake", "no.glb", "-o", "x"}, probe = {"probe", "no.glb", "--points", "p.json", "-o", "x.json"};
    refused(truth, {"--ao-range", "2"}, "--ao-range does nothing without --ao: leave it out, or add that");
    for (const Words& more : {Words{"--bounces", "2"}, {"--scatterings", "1"}, {"--direct-only"}, {"--spectral"}, {"--tracing", "loop"}}) {
        Words asked = more;
        asked.push_back("--ao");
        refused(truth, asked, std::string(more[0]) + " does nothing beside --ao: leave one of them out");
    }
    for (const char* word : {"--bounces", "--scatterings"})
        refused(truth, {"--direct-only", word, "2"}, std::string(word) + " does nothing beside --direct-only: leave one of them out");
    for (const Words& more : {Words{"--shadows", "ray"},
                              {"--ao", "ray"},
                              {"--ao-range", "2"},
                              {"--reflections", "ray"},
                              {"--fog-steps", "8"},
                              {"--fog-resolution", "full"},
                              {"--render-scale", "0.5"},
                              {"--lod-error", "0"},
                              {"--toon-steps", "3"},
                              {"--outline-px", "1"},
                              {"--outline-kinds", "all"},
                              {"--show", "cells"},
                              {"--frames", "2"},
                              {"--layers", "x.exr"},
                              {"--budget-ms", "16"}})
        refused(traced, more, std::string(more[0]) + " does nothing beside --mode truth: leave one of them out");
    refused(traced, {"--effects", "-bloom,+fog"}, "--effects +fog does nothing beside --mode truth: leave one of them out");
    for (const Words& more : {Words{"--portal-depth", "2"}, {"--effects", "-bloom"}, {"--samples", "2"}}) {
        Words words = traced;
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(ask(words).code, 3) << more[0] << " is obeyed there: only the level is missing";
    }
    for (const auto& [word, value, off] : {std::tuple{"--shadows", "ray", "-shadow"},
                                           {"--ao", "ray", "-occlusion"},
                                           {"--ao", "auto", "-occlusion"},
                                           {"--ao-range", "2", "-occlusion"},
                                           {"--reflections", "ray", "-reflection"},
                                           {"--toon-steps", "3", "-toon"},
                                           {"--outline-px", "1", "-outline"},
                                           {"--fog-steps", "8", "-fog"},
                                           {"--portal-depth", "5", "-portal"}})
        for (const Words& verb : {Words{"render", "no.glb", "-o", "x.png"}, {"view", "no.glb"}, {"plan", "no.glb"}, {"graph", "no.glb"}})
            refused(verb, {word, value, "--effects", off},
                    std::string(word) + " does nothing beside --effects " + off + ": leave one of them out");
    const Answer both = ask({"plan", "no.glb", "--effects", "+fog,-fog"});
    EXPECT_EQ(both.code, 2);
    EXPECT_EQ(both.err, "afterglow: --effects +fog,-fog: fog is named both on and off; leave one of them\n");
    refused({"render", "no.glb", "-o", "x.png"}, {"--samples", "8"},
            "--samples does nothing without --mode truth: leave it out, or add that");
    refused(bake, {"--only", "probes", "--denoise", "none"},
            "--denoise does nothing without lightmaps in --only: leave it out, or add that");
    refused(bake, {"--only", "reflections", "--light-cache", "off"},
            "--light-cache does nothing without lightmaps or probes in --only: leave it out, or add that");
    refused(bake, {"--only", "lods,voxels", "--seed", "2"},
            "--seed does nothing without lightmaps, probes or reflections in --only: leave it out, or add that");
    refused(bake, {"--time-budget", "9", "--samples", "2"}, "--samples does nothing beside --time-budget: leave one of them out");
    for (const char* word : {"--light-layers", "--incremental"}) {
        refused(bake, {word, "--time-budget", "9"}, std::string(word) + " does nothing beside --time-budget: leave one of them out");
        refused(bake, {word, "--only", "probes"},
                std::string(word) + " does nothing without lightmaps in --only: leave it out, or add that");
    }
    for (const char* word : {"--samples", "--seed", "--threads"})
        refused(probe, {word, "2"}, std::string(word) + " does nothing without --truth: leave it out, or add that");
    for (const Words& judged : {Words{"plan", "no.glb", "--milliseconds", "16"}, {"render", "no.glb", "-o", "x.png", "--budget-ms", "16"}})
        refused(judged, {"--show", "cells"}, std::string(judged[judged.size() - 2]) + " does nothing beside --show: leave one of them out");
    refused({"plan", "no.glb"}, {"--device", "0"}, "--device does nothing without --milliseconds: leave it out, or add that");
}

TEST(CommandLine, takes_an_option_once_and_no_empty_word)
{
    const Answer twice = ask({"truth", "no.glb", "-o", "x.exr", "--samples", "2", "--samples", "3"});
    EXPECT_EQ(twice.code, 2);
    EXPECT_EQ(twice.err, "afterglow: --samples is said more than once: leave one of them; see `afterglow truth --help`\n");
    const Answer lacking = ask({"truth", "no.glb", "-o", "x.exr", "--ao", "--samples"});
    EXPECT_EQ(lacking.code, 2);
    EXPECT_NE(lacking.err.find("--samples"), std::string::npos) << lacking.err;
    EXPECT_EQ(lacking.err.find("--ao is said"), std::string::npos) << lacking.err;
    for (const char* word : {"--camera", "--device", "--effects", "--stats"}) {
        const Answer empty = ask({"render", "no.glb", "-o", "x.png", word, ""});
        EXPECT_EQ(empty.code, 2);
        EXPECT_EQ(empty.err, "afterglow: the word after '" + std::string(word) + "' is empty: write what is meant, or leave it out\n");
    }
    EXPECT_EQ(ask({"plan", ""}).code, 2);
}

TEST(CommandLine, keeps_its_messages_to_a_line)
{
    const Answer answer = ask({"truth", "no\nsuch\x1b[31m.glb", "-o", "x.exr"});
    EXPECT_EQ(answer.code, 3);
    EXPECT_EQ(answer.err, "afterglow: cannot read no?such?[31m.glb: there is no such file; check the name\n");
}

TEST(CommandLine, does_not_end_well_when_nobody_could_read_it)
{
    const int before = dup(STDOUT_FILENO), full = open("/dev/full", O_WRONLY);
    ASSERT_GE(full, 0);
    std::fflush(stdout);
    dup2(full, STDOUT_FILENO);
    const std::vector<const char*> words = {"afterglow", "plan", "content/truth/furnace.glb"};
    const int code = runCommandLine(int(words.size()), words.data());
    std::clearerr(stdout);
    std::cout.clear();
    dup2(before, STDOUT_FILENO);
    close(before), close(full);
    EXPECT_EQ(code, 3);
}

// A normal of any length is a direction; a point where no level can be is refused.
TEST(CommandLine, probes_about_any_normal)
{
    const std::filesystem::path in = std::filesystem::path(testing::TempDir()) / "probed.json", out = in.string() + ".out";
    const auto probed = [&](const char* point) {
        writeText(in, std::string("{\"points\":[") + point + "]}");
        return ask({"probe", "content/truth/furnace.glb", "--truth", "--samples", "4", "--points", in.c_str(), "-o", out.c_str(),
                    "--progress", "none"});
    };
    std::string first;
    for (const char* normal : {"[0,1,0]", "[0,1e300,0]", "[0,1e30,0]", "[0,1e-19,0]", "[0,1e-300,0]"}) {
        ASSERT_EQ(probed((std::string("{\"position\":[0,0.5,0],\"normal\":") + normal + "}").c_str()).code, 0) << normal;
        const std::string text = readText(out), answer = text.substr(0, text.find("normal"));
        if (first.empty()) first = answer;
        EXPECT_EQ(answer, first) << normal;
    }
    for (const char* position : {"[0,2e18,0]", "[0,1e39,0]", "[0,1e300,0]"})
        EXPECT_EQ(probed((std::string("{\"position\":") + position + "}").c_str()).code, 3) << position;
}

// Who asks beyond the level by a slip of units is told so, and answered all the same.
TEST(CommandLine, says_that_points_lie_outside_of_the_level)
{
    const std::filesystem::path folder(testing::TempDir()), in = folder / "outside.json", out = folder / "outside.out.json",
                                                            baked = folder / "outside.baked";
    ASSERT_EQ(ask({"bake", "content/truth/furnace.glb", "-o", baked.c_str(), "--only", "probes", "--quality", "draft", "--progress", "none",
                   "--force"})
                  .code,
              0);
    const auto asked = [&](const char* points) {
        writeText(in, std::string("{\"points\":[") + points + "]}");
        return ask({"probe", baked.c_str(), "--points", in.c_str(), "-o", out.c_str()});
    };
    EXPECT_EQ(asked("{\"position\":[0,0,0]}").err, "");
    const Answer said = asked("{\"position\":[0,0,0]},{\"position\":[0,1e4,0]}");
    EXPECT_EQ(said.code, 0);
    EXPECT_NE(said.err.find("1 of 2 points lie outside of the level"), std::string::npos) << said.err;
    std::filesystem::remove_all(baked);
}

// A lamp's own light is the runtime's to add, unless the bake was told to hold it.
TEST(CommandLine, says_that_direct_light_is_not_in_a_bake)
{
    const std::filesystem::path folder(testing::TempDir()), in = folder / "direct.json", out = folder / "direct.out.json",
                                                            baked = folder / "direct.baked";
    writeText(in, "{\"points\":[{\"position\":[0,0.5,0]}]}");
    for (const char* direct : {"as-said", "all"}) {
        ASSERT_EQ(ask({"bake", "content/still_life/still_life.glb", "-o", baked.c_str(), "--only", "probes", "--quality", "draft",
                       "--progress", "none", "--force", "--direct", direct})
                      .code,
                  0);
        const Answer said = ask({"probe", baked.c_str(), "--points", in.c_str(), "-o", out.c_str()});
        EXPECT_EQ(said.code, 0) << said.err;
        EXPECT_EQ(said.err.find("the direct part of 1 light is not in this bake") != std::string::npos, direct != std::string("all"))
            << said.err;
    }
    std::filesystem::remove_all(baked);
}

TEST(CommandLine, says_who_draws_the_truth_for_a_display)
{
    const Answer said = ask({"truth", "content/truth/furnace.glb", "-o", "x.png"});
    EXPECT_EQ(said.code, 2);
    EXPECT_NE(said.err.find("`afterglow render content/truth/furnace.glb --mode truth -o X.png`"), std::string::npos) << said.err;
}
}
