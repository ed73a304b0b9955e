// Parser and runner of the command line.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

/// Runs the command of `words` (without the program's name) and returns its exit code. For --help, help, --version and
/// no words at all it prints the text and returns 0. Throws InputError for words that are no command line.
int runCommandLine(std::vector<std::string> words);

}  // namespace tubeplan::app
