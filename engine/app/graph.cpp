// `afterglow graph`: the frame of a level, pass by pass: what each reads and writes, how much, how long.
#include "engine/graph/graph.hpp"
#include "engine/app/level.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/core/log.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/describe.hpp"
#include <cstdio>

namespace afterglow
{
void graphVerb(const GraphCommand& command)
{
    const Target target = loadTarget(command.target);
    const Settings settings = adoptLevel(command.settings, target.scene());
    const Camera camera = findCamera(target.scene(), command.camera);
    Gpu gpu(deviceOptions(command.device));
    Stage stage = makeStage(gpu, target.scene(), target.bake(), settings);
    for (const std::string& line : stage.notes) note(line);
    Graph graph;
    graph.output(drawFrame(graph, stage, nextView(stage, camera, settings), settings).displayed);
    if (command.dot) {
        std::printf("%s", describeDot(graph, compile(graph)).c_str());
        return;
    }
    Executor executor(gpu);
    std::printf("%s", describe(executor.run(graph, stage.level->set)).c_str());
}
}
