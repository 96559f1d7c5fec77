// The files of a study: what their readers rely on.
#include "engine/app/study/files.hpp"
#include "report.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace afterglow
{
// RFC 4180: commas within quotes belong to their cell.
static std::vector<std::string> cells(const std::string& line)
{
    std::vector<std::string> row(1);
    bool quoted = false;
    for (char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            row.emplace_back();
        else
            row.back() += c;
    }
    return row;
}

TEST(StudyFiles, a_table_has_a_row_for_each_point)
{
    std::istringstream lines(csvOf(handMade()));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = cells(line);
    EXPECT_EQ(names.front(), "effect");
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
        const std::vector<std::string> row = cells(line);
        ASSERT_EQ(row.size(), names.size()) << line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (names[i] == "error" && row[1] == "raster") {
                EXPECT_EQ(row[i], "") << "what was not measured is not said";
            } else if (names[i] == "ms" || names[i] == "error" || names[i] == "value") {
                EXPECT_GT(std::stod(row[i]), 0.0) << line;
            }
            if (names[i] == "device") {
                EXPECT_EQ(row[i], "a device, by name");
            }
        }
    }
    EXPECT_EQ(rows, 15);
}

// The page draws study.json: every number of it is a cell of the point's row in study.csv, under the same name.
TEST(StudyFiles, every_number_of_the_page_is_in_the_table)
{
    Report report = handMade();
    for (Subject& subject : report.subjects)
        for (Curve& curve : subject.curves)
            for (Point& point : curve.points) point.median = point.ms + 0.05, point.noise = 0.01;
    std::istringstream lines(csvOf(report));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = cells(line);
    std::map<std::string, std::string> row;
    std::size_t numbers = 0;
    const auto demand = [&](const nlohmann::json& object) {
        for (const auto& [key, value] : object.items()) {
            if (key == "schema" || !(value.is_number() || value.is_string()) || (value.is_number() && std::isnan(value.get<double>())))
                continue;
            if (value.is_number()) {
                ASSERT_TRUE(row.contains(key)) << key;
                EXPECT_NEAR(std::stod(row[key]), value.get<double>(), 1e-5 * std::abs(value.get<double>())) << key;
                ++numbers;
            } else if (row.contains(key)) {
                EXPECT_EQ(row[key], value) << key;
            }
        }
    };
    const nlohmann::json data = jsonOf(report);
    for (const nlohmann::json& subject : data["subjects"])
        for (const nlohmann::json& curve : subject["curves"])
            for (const nlohmann::json& point : curve["points"]) {
                ASSERT_TRUE(std::getline(lines, line));
                const std::vector<std::string> values = cells(line);
                ASSERT_EQ(values.size(), names.size());
                for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
                demand(data), demand(subject), demand(curve), demand(point);
                EXPECT_EQ(row["width"] + " x " + row["height"], "8 x 8");
            }
    EXPECT_FALSE(std::getline(lines, line)) << "and no row is of nothing";
    EXPECT_GT(numbers, 15u * 12u);
}

TEST(StudyFiles, json_holds_what_a_budget_is_made_of)
{
    const nlohmann::json data = jsonOf(handMade());
    EXPECT_EQ(data["schema"], 1);
    EXPECT_EQ(data["device"], "a device, by name");
    const nlohmann::json& curve = data["subjects"][0]["curves"][0];
    EXPECT_EQ(data["subjects"][0]["effect"], "occlusion");
    EXPECT_EQ(curve["knob"], "rays");
    EXPECT_EQ(curve["clock"], "gpu_passes");
    EXPECT_DOUBLE_EQ(curve["expected_slope"], -0.5);
    EXPECT_DOUBLE_EQ(curve["measured_slope"], -0.5);
    EXPECT_TRUE(data["subjects"][0]["curves"][1]["measured_slope"].is_null());
    for (const char* key : {"value", "ms", "ms_spread", "frame_ms", "error", "flip"})
        EXPECT_TRUE(curve["points"][1][key].is_number()) << key;
    EXPECT_EQ(curve["points"][1]["default"], true);
    EXPECT_EQ(curve["points"][0]["default"], false);
    EXPECT_FALSE(curve["points"][0].contains("picture")) << "pictures are the page's";
    const nlohmann::json& raster = data["subjects"][2]["curves"][1];
    EXPECT_EQ(raster["error_unit"], "hits");
    EXPECT_TRUE(nlohmann::json::parse(raster.dump())["points"][0]["error"].is_null());
}

TEST(StudyFiles, a_page_stands_alone_and_no_name_ends_its_script)
{
    const std::string page = pageOf(handMade());
    std::size_t ends = 0;
    for (std::size_t at = 0; (at = page.find("</script", at)) != std::string::npos; ++at) ++ends;
    EXPECT_EQ(ends, 2u) << "the report's and the program's own";
    std::string rest = page;
    const std::string space = "http://www.w3.org"; // the name of a format, not a place
    for (std::size_t at; (at = rest.find(space)) != std::string::npos;) rest.erase(at, space.size());
    EXPECT_EQ(rest.find("http"), std::string::npos);
    EXPECT_EQ(rest.find("@import"), std::string::npos);
    EXPECT_NE(page.find("data:image/jpeg;base64,/9j/"), std::string::npos) << "the signature of every JPEG";

    const std::string opens = "<script type=\"application/json\" id=\"report\">";
    const std::size_t from = page.find(opens) + opens.size();
    const nlohmann::json data = nlohmann::json::parse(page.substr(from, page.find("</script", from) - from));
    EXPECT_EQ(data["level"], handMade().level);
}
}
