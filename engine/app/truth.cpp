#include "engine/app/level.hpp"
#include "engine/app/verbs.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"

namespace afterglow
{
void truthVerb(const TruthCommand& command)
{
    // A baked folder holds its level too: the truth about it is the truth about the level
    // Scene-linear radiance. What lies outside Rec.709 is below 0 there, and .hdr holds nothing below 0
    if (suffix(command.output) == ".png")
        throw Error(command.output.string() + ": truth writes light, as .exr or .hdr; for a picture: `afterglow render " +
                        command.level.string() + " --mode truth -o X.png`",
                    Exit::usage);
    requireEnding(command.output, command.options.spectral ? std::vector<std::string>{".exr"} : std::vector<std::string>{".exr", ".hdr"});
    requireApart({{"-o", command.output}}, {{"LEVEL", command.level}});
    requireWritable(command.output);
    Target target = loadTarget(command.level);
    const Scene& scene = target.scene();
    TruthOptions options = command.options;
    options.camera = findCamera(scene, command.camera);
    Progress progress(command.progress);
    writeExr(command.output, truth(scene, options, progress));
}
}
