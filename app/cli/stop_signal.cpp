#include "app/cli/stop_signal.hpp"

#include <csignal>

#include "app/cli/caller.hpp"

namespace tubeplan::app {

namespace {

// Set by the signal handler. Setting such a flag is one of the few safe operations in a handler.
volatile std::sig_atomic_t stop_noted = 0;

void noteSignal(int signal_number) {
  stop_noted = 1;
  std::signal(signal_number, SIG_DFL);
}

}  // namespace

void noteStopSignals() {
  if (CalledBy::current()) return;
  std::signal(SIGINT, noteSignal);
  std::signal(SIGTERM, noteSignal);
}

bool stopRequested() { return stop_noted != 0; }

}  // namespace tubeplan::app
