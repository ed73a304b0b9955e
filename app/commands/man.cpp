// `tubeplan man`: prints the manual page.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/command_words.hpp"

namespace tubeplan::app {

Run configureMan(CLI::App&) {
  return [] {
    output("{}", manualPage());
    return static_cast<int>(kDone);
  };
}

}  // namespace tubeplan::app
