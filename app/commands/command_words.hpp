// Names and descriptions of all commands and options, collected for shell completion and the manual page.
#pragma once

#include <string>
#include <vector>

namespace tubeplan::app {

struct OptionWords {
  std::vector<std::string> names;  ///< names such as "--json" and "-o"; for a positional argument, only its name
  std::string value;               ///< placeholder of the value, in capitals; empty for a flag
  std::string description;
  std::string initial;  ///< default value; empty if there is none
  bool is_positional = false;
  bool is_required = false;
  bool is_list = false;  ///< takes several values
  char delimiter = 0;    ///< separator of the values in one word; 0 if each value is a separate word
};

struct CommandWords {
  std::string name, summary, example;
  std::vector<OptionWords> options;  ///< options in the order of the help
};

/// Returns the names and descriptions of all commands in the table.
[[nodiscard]] std::vector<CommandWords> commandWords();

/// Returns a shell script that completes commands and options. Throws InputError for an unknown shell.
[[nodiscard]] std::string completionScript(const std::string& shell);

/// Returns the manual page (section 1) in roff.
[[nodiscard]] std::string manualPage();

}  // namespace tubeplan::app
