// Table of the program's commands.
#pragma once

#include <span>

#include "app/cli/command.hpp"

namespace tubeplan::app {

/// Returns the open table: a new command is its file in this folder, its declaration and its row in command_table.cpp.
[[nodiscard]] std::span<const Command> commands();

}  // namespace tubeplan::app
