#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/files.hpp"
#include "engine/app/study/readme.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/gpu/shader.hpp"
#include <sstream>

namespace afterglow
{
namespace
{
constexpr std::size_t kWide = 140; // characters of a line, as the READMEs have them
const std::string kEnd = "<!-- end of study -->";

// Lines of words; a table's rows stay whole.
std::string wrapped(const std::string& text)
{
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); result += '\n') {
        while (!line.starts_with('|') && line.size() > kWide) {
            const std::size_t space = line.rfind(' ', kWide);
            if (space == std::string::npos) break;
            result += line.substr(0, space) + '\n';
            line.erase(0, space + 1);
        }
        result += line;
    }
    return result;
}

// Where `./run study` leaves the pages.
std::string folderOf(const std::string& level) { return "out/study/" + std::filesystem::path(level).stem().string(); }

std::string blockOf(const Subject& subject, const std::string& level, const Report& report)
{
    const std::string command = fmt::format("afterglow study {}{} --effects {} --readmes -o {}", level, report.quick ? " --quick" : "",
                                            subject.name, folderOf(level));
    const std::string opening =
        fmt::format("Printed by `./run study`, that is `{}`: pictures of {} x {}, by {}; {}, load {:.1f}. The default is bold.\n", command,
                    report.size.x, report.size.y, report.device, report.processor, report.load);
    return wrapped(opening + tablesOf(subject));
}
}

std::string nameInReadmes(const std::filesystem::path& level)
{
    return std::filesystem::weakly_canonical(level).lexically_relative(std::filesystem::weakly_canonical(shaderRoot())).generic_string();
}

std::optional<std::string> withStudy(const std::string& readme, const std::string& level, const std::string& tables)
{
    const std::string begin = "<!-- study " + level + " -->\n";
    const std::size_t at = readme.find(begin);
    if (at == std::string::npos) return {};
    const std::size_t from = at + begin.size(), to = readme.find(kEnd, from);
    if (to == std::string::npos) throw Error("the README's study of " + level + " has no " + kEnd + ": write one where its tables end");
    return readme.substr(0, from) + tables + readme.substr(to);
}

std::vector<std::filesystem::path> writeReadmes(const std::filesystem::path& effects, const std::string& level, const Report& report)
{
    std::vector<std::filesystem::path> written;
    bool named = false;
    for (const Subject& subject : report.subjects) {
        const std::filesystem::path readme = effects / subject.name / "README.md";
        std::error_code none;
        if (!std::filesystem::exists(readme, none)) continue;
        const auto text = withStudy(readText(readme), level, blockOf(subject, level, report));
        if (!text) continue;
        named = true;
        if (!subject.whole) {
            warning(readme.string() + " keeps its tables: " + report.device + " cannot turn all of the knobs that they hold");
            continue;
        }
        writeText(readme, *text);
        written.push_back(readme);
    }
    if (!named) warning("no README of an effect names " + level + ": none was written");
    return written;
}
}
