// Ctrl-C as a flag that long work checks now and then.
#pragma once

namespace tubeplan::app {

/// Makes the program note an interrupt (SIGINT) or a request to end (SIGTERM); a second one ends the program at once.
void noteStopSignals();

/// Returns true if an interrupt or a request to end was noted.
[[nodiscard]] bool stopRequested();

/// Exit code of a stopped program, as shells use it: 128 + SIGINT.
inline constexpr int kStoppedExitCode = 130;

}  // namespace tubeplan::app
