#include "app/planning_hooks.hpp"

#include <memory>

#include "app/progress.hpp"
#include "app/stop_signal.hpp"

namespace tubeplan::app {

namespace {

struct StageLine {
  std::string stage;
  std::size_t total = 0;
  std::unique_ptr<Progress> line;
};

}  // namespace

planner::PlanHooks terminalHooks() {
  noteStopSignals();
  const auto shown = std::make_shared<StageLine>();
  planner::PlanHooks hooks;
  hooks.progress = [shown](std::string_view stage, std::size_t done, std::size_t total) {
    if (!shown->line || shown->stage != stage || shown->total != total) {
      shown->line.reset();
      shown->stage = stage;
      shown->total = total;
      shown->line = std::make_unique<Progress>(shown->stage, total);
    }
    shown->line->update(done);
    if (done >= total) shown->line.reset();
  };
  hooks.stop = [] { return stopRequested(); };
  return hooks;
}

}  // namespace tubeplan::app
