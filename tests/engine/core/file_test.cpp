#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static std::filesystem::path folder(const char* name)
{
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

TEST(File, comes_back_as_it_was_written)
{
    const std::filesystem::path path = folder("file_round") / "bytes";
    const std::vector<std::uint8_t> bytes = {0, 1, 255, 10, 13, 0};
    writeFile(path, bytes.data(), bytes.size());
    EXPECT_EQ(readFile(path), bytes);
    writeText(path, "");
    EXPECT_EQ(readText(path), "");
}

TEST(File, is_asked_for_before_long_work_and_leaves_no_trace)
{
    const std::filesystem::path in = folder("file_asked");
    for (const char* name : {"a", "new/folders/c"}) EXPECT_NO_THROW(requireWritable(in / name)) << name;
    for (const char* name : {"a", "b/", "new/folders/c", "."}) EXPECT_NO_THROW(requireWritableFolder(in / name)) << name;
    for (const char* name : {"", ".", "b/"}) EXPECT_THROW(requireWritable(in / name), Error) << name; // a folder is no file
    EXPECT_THROW(requireWritable(""), Error);
    EXPECT_TRUE(std::filesystem::is_empty(in));
    EXPECT_THROW(requireWritable("/proc/nowhere/a"), Error);
    writeText(in / "file", "text");
    EXPECT_THROW(requireWritable(in / "file" / "a"), Error);
    EXPECT_EQ(readText(in / "file"), "text");
}

TEST(File, goes_through_a_link_and_into_a_device)
{
    const std::filesystem::path in = folder("file_linked");
    std::filesystem::create_directories(in / "real");
    for (const char* name : {"there", "not_yet"}) std::filesystem::create_symlink(std::filesystem::path("real") / name, in / name);
    writeText(in / "real" / "there", "old");
    for (const char* name : {"there", "not_yet"}) {
        requireWritable(in / name);
        writeText(in / name, "new");
        EXPECT_TRUE(std::filesystem::is_symlink(in / name)) << name;
        EXPECT_EQ(readText(in / "real" / name), "new") << name;
    }
    std::filesystem::create_symlink("/dev/null", in / "nowhere");
    requireWritable(in / "nowhere");
    writeText(in / "nowhere", "gone");
    EXPECT_TRUE(std::filesystem::is_character_file(in / "nowhere"));
    writeText(in / "no" / ".." / "b", "beside");
    EXPECT_EQ(readText(in / "b"), "beside");
    EXPECT_FALSE(std::filesystem::exists(in / "no"));
}

TEST(File, says_which_and_why_when_it_cannot)
{
    try {
        readFile("/nowhere/at/all");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot read /nowhere/at/all: there is no such file; check the name");
        EXPECT_EQ(error.exit, Exit::badInput);
    }
    EXPECT_THROW(readFile(testing::TempDir()), Error);
    EXPECT_THROW(writeText("/proc/nowhere/at/all", "text"), Error);
}
}
