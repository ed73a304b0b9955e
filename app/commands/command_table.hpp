// Table of the program's commands.
#pragma once

#include <span>

#include "app/cli/command.hpp"

namespace tubeplan::app {

/// Returns the table of commands. A new command needs a file in this folder, and its declaration and row in
/// command_table.cpp.
[[nodiscard]] std::span<const Command> commands();

}  // namespace tubeplan::app
