// `tubeplan completion SHELL`: prints a shell script that completes commands and options.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/command_words.hpp"

namespace tubeplan::app {

Run configureCompletion(CLI::App& cli) {
  const auto shell = std::make_shared<std::string>();
  cli.add_option("SHELL", *shell, "bash, zsh or fish")->required();
  return [shell] {
    output("{}", completionScript(*shell));
    return static_cast<int>(kDone);
  };
}

}  // namespace tubeplan::app
