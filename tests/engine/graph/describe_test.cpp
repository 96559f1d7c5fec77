// A frame in words.
#include "engine/graph/describe.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
TEST(Describe, APassIsALineWithItsReadsWritesBytesAndTime)
{
    FrameStats stats;
    stats.passes.push_back({"fog", 1.5, {"depth", "sunlight"}, {"foggy"}, 3 * 1024 * 1024, 1, 1});
    stats.milliseconds = 1.5;
    const std::string text = describe(stats);
    EXPECT_NE(text.find("fog "), std::string::npos);
    EXPECT_NE(text.find("3.00 MiB"), std::string::npos);
    EXPECT_NE(text.find("1.500 ms  depth sunlight -> foggy"), std::string::npos) << text;
    EXPECT_NE(text.find("1 passes, 1.500 ms"), std::string::npos) << text;
}

TEST(Describe, DotHasANodePerVersionAndDashesWhatIsCulled)
{
    Graph graph;
    const Texture a = graph.texture("a", VK_FORMAT_R8_UNORM, {4, 4}), b = graph.texture("b", VK_FORMAT_R8_UNORM, {4, 4});
    graph.fullscreen("base", "").write(a);
    graph.fullscreen("top", "").modify(a);
    graph.fullscreen("unread", "").write(b);
    graph.output(a);
    const std::string text = describeDot(graph, compile(graph));
    EXPECT_NE(text.find("\"base\" -> \"a 1\""), std::string::npos) << text;
    EXPECT_NE(text.find("\"a 1\" -> \"top\""), std::string::npos) << text;
    EXPECT_NE(text.find("\"top\" -> \"a 2\""), std::string::npos) << text;
    EXPECT_NE(text.find("\"unread\" [shape=box, style=dashed]"), std::string::npos) << text;
}
}
