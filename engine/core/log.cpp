#include "engine/core/log.hpp"
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace afterglow
{
static spdlog::logger& stream()
{
    static spdlog::logger logger = [] {
        spdlog::logger made("afterglow", std::make_shared<spdlog::sinks::stderr_sink_mt>());
        made.set_pattern("afterglow: %v");
        return made;
    }();
    return logger;
}

void note(const std::string& line) { stream().info(line); }
void warning(const std::string& line) { stream().warn("warning: " + line); }
}
