// A command of the program: name, help text and function.
#pragma once

#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace tubeplan::app {

/// Exit codes of the program. Scripts rely on them, so they must not change.
enum ExitCode { kDone = 0, kNegativeAnswer = 1, kBadInput = 2, kInternalError = 3 };

/// Description of all exit codes for the help text, including kStoppedExitCode.
inline constexpr const char* kExitCodes =
    "0 done, 1 a negative answer, 2 bad input, 3 the program failed (out of memory, or a defect), 130 stopped by "
    "Ctrl-C or SIGTERM";

/// Function that does a command's work after the command line has been parsed. Returns the exit code; throws InputError
/// for bad input.
using Run = std::function<int()>;

/// Function that declares a command's arguments on its CLI11 subcommand, and returns the function that runs the command
/// with the parsed values.
using Configure = Run (*)(CLI::App& cli);

struct Command {
  std::string_view name;
  std::string_view summary;  ///< one line, for the list of commands
  std::string_view example;  ///< one or more example command lines, shown by --help
  Configure configure;
};

}  // namespace tubeplan::app
