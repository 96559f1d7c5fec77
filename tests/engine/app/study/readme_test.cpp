// The tables of the effects' READMEs are those that a study prints: every knob of the effect, with the values that it is turned to.
#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/files.hpp"
#include "engine/app/study/readme.hpp"
#include "engine/app/study/sweeps.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/gpu/shader.hpp"
#include "report.hpp"
#include <gtest/gtest.h>
#include <sstream>

namespace afterglow
{
namespace
{
const std::string kEnd = "<!-- end of study -->\n";

using Rows = std::vector<std::vector<std::string>>;

// The cells of each table in a text, bold or not.
std::vector<Rows> tablesIn(std::string text)
{
    for (std::size_t at; (at = text.find("**")) != std::string::npos;) text.erase(at, 2);
    std::vector<Rows> tables;
    std::istringstream lines(text);
    bool within = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("|")) {
            if (!within) tables.emplace_back();
            std::vector<std::string> cells;
            std::istringstream row(line.substr(1));
            for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell.substr(1, cell.size() - 2));
            tables.back().push_back(cells);
        }
        within = line.starts_with("|");
    }
    return tables;
}

std::vector<std::string> headOf(const Sweep& sweep)
{
    std::vector<std::string> head = {sweep.knob + (sweep.unit.empty() ? "" : ", " + sweep.unit)};
    for (std::size_t i = 0; i < sweep.values.size(); ++i)
        head.push_back(sweep.names.empty() ? fmt::format("{:.3g}", sweep.values[i]) : sweep.names[i]);
    return head;
}

// Of each effect that is studied and has a README.
std::map<std::string, std::string> readmes()
{
    std::map<std::string, std::string> found;
    for (const std::string& subject : subjectNames({})) {
        const std::filesystem::path path = shaderRoot() / "engine/effects" / subject / "README.md";
        if (std::filesystem::exists(path)) found[subject] = readText(path);
    }
    return found;
}
}

TEST(StudyReadmes, hold_what_a_study_of_today_would_print)
{
    const auto texts = readmes();
    EXPECT_GE(texts.size(), 13u);
    for (const auto& [subject, text] : texts) {
        std::vector<Sweep> sweeps;
        if (calledBy(subject) == subject && subject != "upscale") sweeps.push_back(drawnOrNot(subject));
        for (const Sweep& sweep : knobs())
            if (sweep.subject == subject) sweeps.push_back(sweep);

        const std::size_t from = text.find("<!-- study "), to = text.find(kEnd);
        ASSERT_TRUE(from != std::string::npos && to != std::string::npos && from < to) << subject << " has no study";
        const std::string level = text.substr(from + 11, text.find(" -->", from) - from - 11);
        EXPECT_TRUE(std::filesystem::exists(shaderRoot() / level)) << subject << " names " << level;
        const std::vector<Rows> tables = tablesIn(text.substr(from, to - from));
        ASSERT_EQ(tables.size(), sweeps.size()) << subject << ": ./run study prints it anew";
        for (std::size_t i = 0; i < sweeps.size(); ++i) {
            EXPECT_EQ(tables[i].front(), headOf(sweeps[i])) << subject << ": ./run study prints it anew";
            ASSERT_EQ(tables[i].size(), 4u) << "knob, line, time, error";
            EXPECT_EQ(tables[i][2].size(), tables[i][0].size());
            EXPECT_EQ(tables[i][3].size(), tables[i][0].size());
        }
    }
}

TEST(StudyReadmes, call_a_level_by_its_path_from_the_root)
{
    EXPECT_EQ(nameInReadmes(shaderRoot() / "content" / "." / "cornell" / ".." / "cornell" / "cornell.glb"), "content/cornell/cornell.glb");
    EXPECT_EQ(nameInReadmes(std::filesystem::relative(shaderRoot()) / "content/cornell/cornell.glb"), "content/cornell/cornell.glb");
}

TEST(StudyReadmes, are_written_between_their_marks_and_nowhere_else)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "study_readmes";
    const std::string before = "# Occlusion\nWords.\n\n<!-- study a/level.glb -->\n", after = kEnd + "\nMore words.\n", mine = "| old |\n";
    writeText(folder / "occlusion" / "README.md", before + mine + after);
    writeText(folder / "fog" / "README.md", before + mine); // never closed
    Report report = handMade();
    report.subjects.pop_back(), report.subjects.pop_back();
    testing::internal::CaptureStderr();
    EXPECT_TRUE(writeReadmes(folder, "another/level.glb", report).empty());
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no README of an effect names another/level.glb"), std::string::npos);
    EXPECT_EQ(readText(folder / "occlusion" / "README.md"), before + mine + after);

    EXPECT_EQ(writeReadmes(folder, "a/level.glb", report), std::vector{folder / "occlusion" / "README.md"});
    const std::string once = readText(folder / "occlusion" / "README.md");
    EXPECT_TRUE(once.starts_with(before) && once.ends_with(after)) << once;
    EXPECT_EQ(once.find(mine), std::string::npos);
    EXPECT_NE(once.find("| rays, per pixel | 1 | **4** | 16 |\n| --- | --- | --- | --- |\n| time of its passes | 1 ms | 4 ms | 16 ms |\n"),
              std::string::npos)
        << once;
    std::istringstream lines(once);
    for (std::string line; std::getline(lines, line);) EXPECT_TRUE(line.size() <= 140 || line.starts_with("|")) << line;
    writeReadmes(folder, "a/level.glb", report);
    EXPECT_EQ(readText(folder / "occlusion" / "README.md"), once) << "once is enough";

    EXPECT_NE(once.find("--readmes -o out/study/level`"), std::string::npos) << once;

    report.subjects[0].whole = false; // a device that lacks something says so, and leaves what another one printed
    report.subjects[0].curves.pop_back();
    testing::internal::CaptureStderr();
    EXPECT_TRUE(writeReadmes(folder, "a/level.glb", report).empty());
    EXPECT_NE(testing::internal::GetCapturedStderr().find("keeps its tables: a device, by name cannot"), std::string::npos);
    EXPECT_EQ(readText(folder / "occlusion" / "README.md"), once);

    EXPECT_THROW(writeReadmes(folder, "a/level.glb", handMade()), Error);
    std::filesystem::remove_all(folder);
}
}
