#include "engine/core/interrupt.hpp"
#include "engine/core/error.hpp"
#include <atomic>
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace afterglow
{
// A signal handler can reach nothing else.
static std::atomic<bool> asked{false}, listening{false}, written{false}, watching{false};
static std::atomic<int> writing{0}; // scaffolds that stand
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free, "or a handler may not touch them");

static constexpr std::string_view kName = "afterglow: ";
static constexpr std::string_view kSaid = "afterglow: interrupted: nothing was written; run the same command again\n";
static constexpr std::string_view kSaidWritten = "afterglow: interrupted: what was written before is whole; run the same command again\n";

static constexpr std::string_view kSaidWatching = "afterglow: interrupted\n";

static std::string_view sentence() { return watching ? kSaidWatching : written ? kSaidWritten : kSaid; }

static void interrupt(int)
{
    const bool first = !asked.exchange(true);
    if (writing > 0 || (listening && first)) return;
    const std::string_view said = sentence();
    const auto heard = write(STDERR_FILENO, said.data(), said.size());
    static_cast<void>(heard); // whether or not somebody reads it
    _exit(int(Exit::interrupted));
}

void hearInterrupts()
{
    asked = listening = written = watching = false;
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
}

void beginInterruptible() { listening = true; }

void endInterruptible() { listening = false; }

void beginWriting() { ++writing; }

void endWriting() { --writing; }

void tellWritten()
{
    if (writing == 1) written = true;
}

void tellWatching() { watching = true; }

void stopIfInterrupted()
{
    if (!asked) return;
    const std::string_view said = sentence();
    throw Error(std::string(said.substr(kName.size(), said.size() - kName.size() - 1)), Exit::interrupted);
}
}
