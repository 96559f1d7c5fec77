// afterglow: thin on purpose, so that tests call the very function that users call.
#include "engine/app/cli.hpp"

int main(int argc, char** argv) { return afterglow::runCommandLine(argc, argv); }
