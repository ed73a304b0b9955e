#include "app/cli/caller.hpp"

#include <cstdio>

#include "app/cli/stop_signal.hpp"

namespace tubeplan::app {

namespace {

thread_local CommandCaller* caller_of_thread = nullptr;

}  // namespace

CalledBy::CalledBy(CommandCaller& caller) : before_(caller_of_thread) { caller_of_thread = &caller; }

CalledBy::~CalledBy() { caller_of_thread = before_; }

CommandCaller* CalledBy::current() { return caller_of_thread; }

void writeOutput(std::string_view text) {
  if (caller_of_thread)
    caller_of_thread->output += text;
  else
    fmt::print("{}", text);
}

void writeRemark(std::string_view text) {
  if (caller_of_thread)
    caller_of_thread->remarks += text;
  else
    fmt::print(stderr, "{}", text);
}

std::function<bool()> stopCondition() {
  if (!caller_of_thread) return stopRequested;
  return [stop = caller_of_thread->hooks.stop] { return calibration::shouldStop(stop); };
}

}  // namespace tubeplan::app
