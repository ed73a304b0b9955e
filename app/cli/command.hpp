// What a command of the program is. The table of them is in commands.cpp; each command is a file of its own in
// commands/.
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace tubeplan::app {

/// Exit codes, a promise to scripts.
enum ExitCode { kDone = 0, kNegativeAnswer = 1, kBadInput = 2, kInternalError = 3 };

/// The same for a reader, with kStoppedExitCode.
inline constexpr const char* kExitCodes =
    "0 done, 1 a negative answer, 2 bad input, 3 the program failed (no memory left, or a defect of it), "
    "130 stopped by Ctrl-C or SIGTERM";

/// Does the work once the command line is read; returns the exit code. Throws InputError for bad input.
using Run = std::function<int()>;

/// Declares the command's arguments on its part of the command line, and returns what is to be run with them.
using Configure = Run (*)(CLI::App& cli);

struct Command {
  std::string_view name;
  std::string_view summary;  ///< one line, for the overview
  std::string_view example;  ///< one line or more, shown by --help
  Configure configure;
};

/// The open table: a new command is its file and its row.
[[nodiscard]] std::span<const Command> commands();

// Declared here, defined in commands/<name>.cpp.
Run configureAdd(CLI::App& cli);
Run configureArm(CLI::App& cli);
Run configureCalibrate(CLI::App& cli);
Run configureCampaign(CLI::App& cli);
Run configureCompare(CLI::App& cli);
Run configureCompletion(CLI::App& cli);
Run configureDiagnose(CLI::App& cli);
Run configureIdentify(CLI::App& cli);
Run configureImprove(CLI::App& cli);
Run configureLadder(CLI::App& cli);
Run configureMan(CLI::App& cli);
Run configureMap(CLI::App& cli);
Run configureEffects(CLI::App& cli);
Run configurePlan(CLI::App& cli);
Run configurePose(CLI::App& cli);
Run configureReadings(CLI::App& cli);
Run configureReport(CLI::App& cli);
Run configureScore(CLI::App& cli);
Run configureSimulate(CLI::App& cli);
Run configureSensitivity(CLI::App& cli);
Run configureServe(CLI::App& cli);
Run configureTouches(CLI::App& cli);
Run configureVerify(CLI::App& cli);

}  // namespace tubeplan::app
