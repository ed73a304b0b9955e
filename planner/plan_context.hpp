// Input shared by all stages of planning the visits. Internal to the planning.
#pragma once

#include <string_view>

#include "planner/collision/arm_clearance.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// The cell, the options, the caller's hooks and the cache. Each stage first looks for its results in the cache, and
/// adds new results to it.
struct PlanContext {
  const Workcell& cell;
  const VisitPlanOptions& options;
  const PlanHooks& hooks;
  PlanCache& cache;
  const ArmClearance clearance{cell, options.reach.padding};
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);

  [[nodiscard]] bool isStopped() const { return hooks.stop && hooks.stop(); }
  void showProgress(std::string_view stage, std::size_t done, std::size_t total) const {
    if (hooks.progress) hooks.progress(stage, done, total);
  }
  void keepCache() const {
    if (hooks.keep) hooks.keep(cache);
  }
};

}  // namespace tubeplan::planner
