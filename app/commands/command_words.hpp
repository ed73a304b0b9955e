// The words of the command line, as the commands declare them: for shells that complete them, and for the manual page.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct OptionWords {
  std::vector<std::string> names;  ///< "--json", "-o"; of a positional argument its name alone
  std::string value;               ///< what follows it, in capitals; empty for a flag
  std::string description;
  std::string initial;  ///< what it is where nothing is said; empty without
  bool is_positional = false;
};

struct CommandWords {
  std::string name, summary, example;
  std::vector<OptionWords> options;  ///< in the order of their help
};

/// Of the whole table.
[[nodiscard]] std::vector<CommandWords> commandWords();

/// A script that makes the shell complete commands and options. Throws InputError for a shell that is not known.
[[nodiscard]] std::string completionScript(const std::string& shell);

/// The manual page, section 1, in roff.
[[nodiscard]] std::string manualPage();

}  // namespace tubeplan::app
