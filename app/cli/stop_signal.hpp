// Records Ctrl-C in a flag that long-running work polls.
#pragma once

namespace tubeplan::app {

/// Installs handlers that record SIGINT (Ctrl-C) and SIGTERM; leaves the signals of another calling program alone. A
/// second signal of the same kind ends the program at once.
void noteStopSignals();

/// Returns true if SIGINT or SIGTERM was received since noteStopSignals().
[[nodiscard]] bool stopRequested();

/// Exit code of a program stopped by a signal, following the shell convention: 128 + SIGINT.
inline constexpr int kStoppedExitCode = 130;

}  // namespace tubeplan::app
