#include "engine/core/log.hpp"
#include <nlohmann/json.hpp>
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

static bool& asJson()
{
    static bool json = false;
    return json;
}

void sayAsJson()
{
    asJson() = true;
    stream().set_pattern("%v");
}

static std::string worded(const char* kind, const std::string& line) // bytes that are no UTF-8 become U+FFFD
{
    return nlohmann::json{{"stage", nullptr}, {kind, line}}.dump(-1, ' ', /* ensure_ascii= */ false,
                                                                 nlohmann::json::error_handler_t::replace);
}

void note(const std::string& line) { stream().info(asJson() ? worded("note", line) : oneLine(line)); }
void warning(const std::string& line) { stream().warn(asJson() ? worded("warning", line) : "warning: " + oneLine(line)); }

Hush::Hush() : level_(int(stream().level())) { stream().set_level(spdlog::level::off); }
Hush::~Hush() { stream().set_level(spdlog::level::level_enum(level_)); }

std::string oneLine(std::string text)
{
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto code = static_cast<unsigned char>(text[i]);
        const bool goesOn = text[i] == '\n' && text.compare(i + 1, 2, "  ") == 0;
        if ((code < 0x20 && !goesOn) || code == 0x7f) text[i] = '?';
    }
    return text;
}
}
