// What the program says while it works: warnings and notes on stderr; results go to stdout, errors leave by Error.
#pragma once
#include <string>

namespace afterglow
{
void note(const std::string& line);    // `afterglow: line`
void warning(const std::string& line); // `afterglow: warning: line`

// The text with `?` for what a terminal would obey, as a name in a file may hold; a line of ours that goes on, indented, stays.
std::string oneLine(std::string text);
}
