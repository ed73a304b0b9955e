#include "app/cli/planning_hooks.hpp"

#include <functional>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/stop_signal.hpp"

namespace tubeplan::app {

namespace {

struct StageLine {
  std::string stage;
  std::size_t total = 0;
  std::unique_ptr<Progress> line;
};

using StageProgress = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

StageProgress stageLines() {
  return [shown = std::make_shared<StageLine>()](std::string_view stage, std::size_t done, std::size_t total) {
    if (!shown->line || shown->stage != stage || shown->total != total) {
      shown->line.reset();
      shown->stage = stage;
      shown->total = total;
      shown->line = std::make_unique<Progress>(shown->stage, total);
    }
    shown->line->update(done);
    if (total > 0 && done >= total) shown->line.reset();
  };
}

}  // namespace

planner::PlanHooks terminalHooks() {
  auto [progress, stop] = terminalWorkHooks();
  planner::PlanHooks hooks;
  hooks.progress = std::move(progress);
  hooks.stop = std::move(stop);
  return hooks;
}

calibration::WorkHooks terminalWorkHooks() {
  noteStopSignals();
  const CommandCaller* caller = CalledBy::current();
  return {caller ? caller->hooks.progress : stageLines(), stopCondition()};
}

}  // namespace tubeplan::app
