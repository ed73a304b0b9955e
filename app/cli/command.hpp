// A command of the program: its name, its words and its function.
#pragma once

#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace tubeplan::app {

/// Exit codes, a promise to scripts.
enum ExitCode { kDone = 0, kNegativeAnswer = 1, kBadInput = 2, kInternalError = 3 };

/// Exit codes in words for a reader, including kStoppedExitCode.
inline constexpr const char* kExitCodes =
    "0 done, 1 a negative answer, 2 bad input, 3 the program failed (no memory left, or a defect of it), "
    "130 stopped by Ctrl-C or SIGTERM";

/// Function that does the work after the command line is read, and returns the exit code. Throws InputError for bad
/// input.
using Run = std::function<int()>;

/// Function that declares the command's arguments on its part of the command line, and returns the function to run with
/// them.
using Configure = Run (*)(CLI::App& cli);

struct Command {
  std::string_view name;
  std::string_view summary;  ///< one line, for the overview
  std::string_view example;  ///< one line or more, shown by --help
  Configure configure;
};

}  // namespace tubeplan::app
