// Ctrl-C as a question that long work asks now and then.
#pragma once

namespace tubeplan::app {

/// From now on an interrupt (SIGINT) or a request to end (SIGTERM) is noted; a second one ends the program at once.
void noteStopSignals();

/// Whether one came.
[[nodiscard]] bool stopRequested();

/// What main returns then, as shells do: 128 + SIGINT.
inline constexpr int kStoppedExitCode = 130;

}  // namespace tubeplan::app
