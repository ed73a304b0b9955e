// Options of commands with several actions, such as `arm import`: each option belongs to some actions, or to all.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

/// One action of a command, with the options and arguments that not all actions have: "--out", "TUBE".
struct ActionOptions {
  std::string action;
  std::vector<std::string> options;
};

/// Throws InputError for an option on the command line that belongs to other actions alone, because it would have no
/// effect. Options that no action of the table names belong to all.
void requireOptionsOf(const CLI::App& cli, const std::string& action, const std::vector<ActionOptions>& table);

}  // namespace tubeplan::app
