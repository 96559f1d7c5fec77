// The three kinds of failure: a programmer's (check), the world's (Error, caught once in app/cli.cpp), an expected absence (std::optional).
#pragma once
#include <stdexcept>
#include <string>

namespace afterglow
{
// Exit codes of the command line; scripts rely on them.
enum class Exit { done = 0, usage = 2, badInput = 3, noDevice = 4, interrupted = 130 };

// One sentence for a person: what happened, which file or option, what to do.
class Error : public std::runtime_error
{
public:
    explicit Error(const std::string& sentence, Exit code = Exit::badInput) : std::runtime_error(sentence), exit(code) {}
    Exit exit;
};

[[noreturn]] void failedCheck(const char* condition, const char* file, int line, const std::string& message);
}

// A programmer's promise, always on: prints both and aborts.
#define check(condition, message)                                                                                                          \
    do {                                                                                                                                   \
        if (!(condition)) ::afterglow::failedCheck(#condition, __FILE__, __LINE__, message);                                               \
    } while (false)
