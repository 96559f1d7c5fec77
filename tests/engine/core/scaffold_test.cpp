#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/scaffold.hpp"
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace afterglow
{
static std::filesystem::path folder(const char* name)
{
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

static std::ptrdiff_t entries(const std::filesystem::path& in) { return std::distance(std::filesystem::directory_iterator(in), {}); }

TEST(Scaffold, leaves_what_was_built_and_nothing_else)
{
    const std::filesystem::path in = folder("scaffold_file");
    writeText(in / "a", "text");
    EXPECT_EQ(readText(in / "a"), "text");
    EXPECT_EQ(entries(in), 1);
    std::filesystem::create_directories(in / "b" / "full"); // a folder in the way: nothing can take its place
    EXPECT_THROW(writeText(in / "b", "text"), Error);
    EXPECT_EQ(entries(in), 2);
}

TEST(Scaffold, leaves_nothing_when_it_failed)
{
    const std::filesystem::path in = folder("scaffold_failed");
    for (Scaffold::Kind kind : {Scaffold::Kind::file, Scaffold::Kind::folder}) {
        const Scaffold failed(in / "a", kind);
        EXPECT_EQ(entries(in), 1);
    }
    EXPECT_TRUE(std::filesystem::is_empty(in));
}

// Whoever has a file of the name that we would take keeps it.
TEST(Scaffold, takes_no_name_that_is_taken)
{
    const std::filesystem::path in = folder("scaffold_foreign");
    for (const char* end : {".tmp", ".writing", ".old"}) writeText(in / (std::string("a") + end), "foreign");
    std::string ours;
    {
        ours = Scaffold(in / "a", Scaffold::Kind::file).path();
        std::filesystem::create_directories(ours);
        writeText(std::filesystem::path(ours) / "photo", "foreign");
        writeText(in / "a", "mine");
        Scaffold whole(in / "b", Scaffold::Kind::folder);
        whole.takePlace();
    }
    EXPECT_EQ(readText(in / "a"), "mine");
    EXPECT_EQ(readText(std::filesystem::path(ours) / "photo"), "foreign");
    for (const char* end : {".tmp", ".writing", ".old"}) EXPECT_EQ(readText(in / (std::string("a") + end)), "foreign");
}

TEST(Scaffold, folder_takes_another_s_place_at_once)
{
    const std::filesystem::path in = folder("scaffold_exchange");
    std::filesystem::create_directories(in / "old");
    writeText(in / "old" / "text", "old");
    {
        Scaffold built(in / "old", Scaffold::Kind::folder);
        writeText(built.path() / "text", "new");
        EXPECT_EQ(readText(in / "old" / "text"), "old");
        built.takePlace();
        EXPECT_EQ(readText(in / "old" / "text"), "new");
    }
    {
        Scaffold built(in / "deep" / "new", Scaffold::Kind::folder); // nothing there yet, nor the folder above
        built.takePlace();
    }
    EXPECT_TRUE(std::filesystem::is_directory(in / "deep" / "new"));
    EXPECT_EQ(entries(in), 2);
}

TEST(Scaffold, place_has_one_name)
{
    for (const char* name : {"/a/b", "/a/b/", "/a/./b/.", "/a/c/../b"}) EXPECT_EQ(placeOf(name), "/a/b") << name;
    const std::filesystem::path here = std::filesystem::canonical(std::filesystem::current_path());
    EXPECT_EQ(placeOf("b/"), here / "b");
    EXPECT_EQ(placeOf("."), here);
    const std::filesystem::path in = folder("scaffold_ring");
    std::filesystem::create_symlink("ring", in / "ring");
    EXPECT_THROW(writeText(in / "ring", "text"), Error);
}

// A process that is gone: what was killed leaves its scaffold, and the next one at the same place removes it, and nothing else.
TEST(Scaffold, removes_what_a_killed_program_left)
{
    const std::filesystem::path in = folder("scaffold_stale");
    const pid_t child = fork();
    if (child == 0) {
        new Scaffold(in / "a", Scaffold::Kind::folder);
        new Scaffold(in / "other", Scaffold::Kind::folder);
        _exit(0); // as SIGKILL: nothing is destroyed
    }
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    std::filesystem::create_directories(in / "a.writing-kept");
    ASSERT_EQ(entries(in), 3);
    const Scaffold alive(in / "a", Scaffold::Kind::folder);
    EXPECT_FALSE(std::filesystem::exists(in / ("a.writing-" + std::to_string(child))));
    const Scaffold second(in / "a", Scaffold::Kind::folder);
    EXPECT_TRUE(std::filesystem::exists(alive.path()));
    EXPECT_TRUE(std::filesystem::exists(in / ("other.writing-" + std::to_string(child)))); // of another place
    EXPECT_TRUE(std::filesystem::exists(in / "a.writing-kept"));
}

// As if it had been made by hand.
TEST(Scaffold, is_for_whom_the_mask_says)
{
    const std::filesystem::path in = folder("scaffold_mode");
    const mode_t before = umask(022);
    writeText(in / "a", "text");
    Scaffold(in / "b", Scaffold::Kind::folder).takePlace();
    umask(before);
    using std::filesystem::perms;
    EXPECT_EQ(std::filesystem::status(in / "a").permissions(), perms(0644));
    EXPECT_EQ(std::filesystem::status(in / "b").permissions(), perms(0755));
}
}
