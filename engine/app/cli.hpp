// The command line: words in, exit code out (design.md has the list; scripts rely on it).
#pragma once

namespace afterglow
{
// Parses and runs one verb. An Error becomes one sentence on stderr and its exit code; wrong usage is exit code 2.
int runCommandLine(int argc, const char* const* argv);
}
