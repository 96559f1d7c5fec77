#include "engine/core/interrupt.hpp"
#include "engine/core/error.hpp"
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace afterglow
{
// A signal handler can reach nothing else.
static volatile std::sig_atomic_t asked = 0, listening = 0;

static constexpr std::string_view kName = "afterglow: ";
static constexpr std::string_view kSaid = "afterglow: interrupted: nothing was written; run the same command again\n";

static void interrupt(int)
{
    if (listening != 0 && asked == 0) {
        asked = 1;
        return;
    }
    const auto written = write(STDERR_FILENO, kSaid.data(), kSaid.size());
    static_cast<void>(written); // whether or not somebody reads it
    _exit(int(Exit::interrupted));
}

void hearInterrupts()
{
    asked = 0;
    listening = 0;
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
}

void beginInterruptible() { listening = 1; }

void endInterruptible() { listening = 0; }

void stopIfInterrupted()
{
    if (asked != 0) throw Error(std::string(kSaid.substr(kName.size(), kSaid.size() - kName.size() - 1)), Exit::interrupted);
}
}
