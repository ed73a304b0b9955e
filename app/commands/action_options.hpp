// Commands with several actions, such as `arm import`: each option belongs to some actions, or to all.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

/// One action of a command, with its words for --help, and the options and arguments that not all actions have:
/// "--out", "TUBE".
struct ActionOptions {
  std::string action, words;
  std::vector<std::string> options;
};

/// Adds the argument ACTION. After an action, --help is about that action: its words, its options and its examples. A
/// part of an option's description that begins with names of actions, such as "plan, next: only this leg; mark: ...",
/// is shown for these actions alone, and one that begins with "all others: " for those without a part of their own.
void addAction(CLI::App& cli, std::string& action, const std::vector<ActionOptions>& table);

/// Throws InputError for an option on the command line that belongs to other actions alone, because it would have no
/// effect. Options that no action of the table names belong to all.
void requireOptionsOf(const CLI::App& cli, const std::string& action, const std::vector<ActionOptions>& table);

}  // namespace tubeplan::app
