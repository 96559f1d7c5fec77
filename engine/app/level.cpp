#include "engine/app/level.hpp"
#include "engine/core/error.hpp"
#include "engine/core/log.hpp"

namespace afterglow
{
Target loadTarget(const std::filesystem::path& path)
{
    Target target;
    if (std::filesystem::is_directory(path)) {
        if (!isBaked(path)) throw Error(path.string() + " is a folder but not a bake: it holds no bake.json");
        target.baked = readBaked(path);
    } else {
        target.level = loadLevel(path);
    }
    if (const std::string line = droppedText(target.scene()); !line.empty()) note(line);
    for (const std::string& line : target.scene().warnings) warning(line);
    return target;
}
}
