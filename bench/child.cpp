#include "bench/child.hpp"
#include "engine/core/error.hpp"
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace afterglow
{
using nlohmann::json;

// The child's side: the answer, or the sentence of its failure, as text into the pipe.
[[noreturn]] static void answer(int pipeEnd, const std::function<json()>& work)
{
    json said;
    try {
        said["answer"] = work();
    } catch (const Error& error) {
        said = {{"error", error.what()}, {"exit", int(error.exit)}};
    } catch (const std::exception& error) {
        said = {{"error", error.what()}, {"exit", int(Exit::badInput)}};
    }
    const std::string text = said.dump();
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t now = write(pipeEnd, text.data() + sent, text.size() - sent);
        if (now <= 0) break;
        sent += std::size_t(now);
    }
    _exit(0);
}

static std::string readAll(int pipeEnd)
{
    std::string text;
    std::array<char, 4096> part;
    for (ssize_t now; (now = read(pipeEnd, part.data(), part.size())) > 0;) text.append(part.data(), std::size_t(now));
    return text;
}

static double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

json inChild(const std::function<json()>& work)
{
    std::array<int, 2> ends{};
    std::fflush(nullptr); // or the child prints what waits here a second time
    const auto began = std::chrono::steady_clock::now();
    const auto interrupt = std::signal(SIGINT, SIG_IGN); // the child's to answer; we then leave by an Error, and tidy up
    const pid_t child = pipe(ends.data()) == 0 ? fork() : -1;
    if (child < 0) throw Error("the system gives no process to measure in: end some others, then run this again");
    if (child == 0) {
        std::signal(SIGINT, SIG_DFL);
        close(ends[0]);
        answer(ends[1], work);
    }
    close(ends[1]);
    const std::string text = readAll(ends[0]);
    close(ends[0]);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    std::signal(SIGINT, interrupt);

    json said = json::parse(text, nullptr, /* allow_exceptions= */ false);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) throw Error("interrupted", Exit::interrupted);
    if (said.is_discarded()) throw Error("a measurement died by signal " + std::to_string(WIFSIGNALED(status) ? WTERMSIG(status) : 0));
    if (said.contains("error")) throw Error(said["error"].get<std::string>(), Exit(said["exit"].get<int>()));
    json& result = said["answer"];
    result["process"] = {{"wall_seconds", std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count()},
                         {"cpu_seconds", seconds(used.ru_utime) + seconds(used.ru_stime)},
                         {"peak_mib", double(used.ru_maxrss) / 1024.0}}; // KiB: the child's VmHWM
    return result;
}
}
