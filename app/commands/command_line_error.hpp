// Error messages, in sentences, for command lines that cannot be parsed.
#pragma once

#include <string>
#include <vector>

#include "app/storage/input_error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace tubeplan::app {

/// Returns the error message for arguments that CLI11 refused for a command. An unknown option is reported before any
/// other mistake. `words` are the arguments in their order on the command line.
[[nodiscard]] InputError commandLineError(const CLI::ParseError& error, CLI::App& command,
                                          const std::vector<std::string>& words);

}  // namespace tubeplan::app
