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

TEST(File, leaves_nothing_beside_itself)
{
    const std::filesystem::path in = folder("file_beside");
    writeText(in / "a", "text");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(in), {}), 1);
    std::filesystem::create_directories(in / "b" / "full"); // a folder in the way: the rename fails
    EXPECT_THROW(writeText(in / "b", "text"), Error);
    EXPECT_FALSE(std::filesystem::exists(in / "b.tmp"));
}

TEST(File, folder_takes_another_s_place_at_once)
{
    const std::filesystem::path in = folder("file_exchange");
    for (const char* name : {"old", "new"}) {
        std::filesystem::create_directories(in / name);
        writeText(in / name / "text", name);
    }
    exchangeFolders(in / "new", in / "old");
    EXPECT_EQ(readText(in / "old" / "text"), "new");
    EXPECT_EQ(readText(in / "new" / "text"), "old");
    exchangeFolders(in / "new", in / "third"); // nothing there yet
    EXPECT_EQ(readText(in / "third" / "text"), "old");
    EXPECT_FALSE(std::filesystem::exists(in / "new"));
    EXPECT_THROW(exchangeFolders(in / "absent", in / "old"), Error);
    EXPECT_EQ(readText(in / "old" / "text"), "new");
}

TEST(File, says_which_and_why_when_it_cannot)
{
    try {
        readFile("/nowhere/at/all");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot read /nowhere/at/all: No such file or directory");
        EXPECT_EQ(error.exit, Exit::badInput);
    }
    EXPECT_THROW(readFile(testing::TempDir()), Error);
    EXPECT_THROW(writeText("/nowhere/at/all", "text"), Error);
}
}
