// What the program says while it works: warnings and notes on stderr; results go to stdout, errors leave by Error.
#pragma once
#include <string>

namespace afterglow
{
void note(const std::string& line);    // `afterglow: line`
void warning(const std::string& line); // `afterglow: warning: line`

void sayAsJson(); // from now on {"note": line, "stage": null}, or "warning", for machines that read stages' progress from the same stream

// While one lives, neither is printed: of a trial, or of what will be said again.
class Hush
{
public:
    Hush();
    ~Hush();
    Hush(const Hush&) = delete;

private:
    int level_; // of before
};

// The text with `?` for what a terminal would obey, as a name in a file may hold; a line of ours that goes on, indented, stays.
std::string oneLine(std::string text);
}
