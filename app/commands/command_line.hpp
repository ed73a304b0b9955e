// From the words of the command line to an exit code.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

/// Runs the command that `words` (without the program's name) ask for. Returns its exit code; for --help, help,
/// --version and no words at all prints what is asked and returns 0. Throws InputError for words that make no command
/// line.
int runCommandLine(std::vector<std::string> words);

}  // namespace tubeplan::app
