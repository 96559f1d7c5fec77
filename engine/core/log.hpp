// What the program says while it works: warnings and notes on stderr; results go to stdout, errors leave by Error.
#pragma once
#include <string>

namespace afterglow
{
void note(const std::string& line);    // `afterglow: line`
void warning(const std::string& line); // `afterglow: warning: line`
}
