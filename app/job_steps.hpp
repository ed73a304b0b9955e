// How long work outside the planner tells what it is at.
#pragma once

#include <functional>
#include <string_view>

namespace tubeplan::app {

/// Called as a step begins ("fit", "diagnosis"). May throw to end the work there. Empty: nobody asks.
using StepHook = std::function<void(std::string_view step)>;

inline void beginStep(const StepHook& hook, std::string_view step) {
  if (hook) hook(step);
}

}  // namespace tubeplan::app
