#include "engine/core/error.hpp"
#include <cstdio>
#include <cstdlib>

namespace afterglow
{
void failedCheck(const char* condition, const char* file, int line, const std::string& message)
{
    std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, message.c_str(), condition);
    std::abort();
}
}
