// The errors of a command's words, in sentences.
#pragma once

#include <string>
#include <vector>

#include "app/storage/input_error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace tubeplan::app {

/// Returns the error of the words that CLI11 refused for a command. An unknown option comes before every other mistake.
/// `words` are those of the command line in their order.
[[nodiscard]] InputError commandLineError(const CLI::ParseError& error, CLI::App& command,
                                          const std::vector<std::string>& words);

}  // namespace tubeplan::app
