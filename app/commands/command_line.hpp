// Parsing and execution of the command line.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

/// Runs the command given by the arguments `words` (without the program name) and returns its exit code. For --help,
/// help, --version, --cells or no arguments, prints the text and returns 0. Throws InputError for invalid arguments.
int runCommandLine(std::vector<std::string> words);

}  // namespace tubeplan::app
