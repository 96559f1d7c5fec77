// --progress json: a machine that reads the stream meets nothing else.
#include "tests/engine/app/program.hpp"
#include <nlohmann/json.hpp>
#include <sstream>

namespace afterglow
{
TEST(Machine, readsJsonLineByLine)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("machine_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::filesystem::path told = folder / "told";
    ASSERT_EQ(wait(startProgram({"bake", "content/pool/pool.glb", "-o", folder / "pool.baked", "--only", "lightmaps", "--samples", "1",
                                 "--texels-per-metre", "2", "--progress", "json"},
                                told)),
              0)
        << readText(told);
    std::istringstream lines(readText(told));
    int stages = 0, warnings = 0;
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json said = nlohmann::json::parse(line, nullptr, /* allow_exceptions= */ false);
        ASSERT_TRUE(said.is_object()) << line;
        ASSERT_TRUE(said.contains("stage")) << line;
        stages += said["stage"].is_string() ? 1 : 0;
        warnings += said.contains("warning") ? 1 : 0;
    }
    EXPECT_GT(stages, 2);
    EXPECT_GT(warnings, 0) << "the paving has edges of three faces";
    std::filesystem::remove_all(folder);
}
}
