#include "app/studies/model/ladder_steps.hpp"

#include <cmath>

namespace tubeplan::app {

const ModelComparisonRow* bestRow(const std::vector<ModelComparisonRow>& comparison) {
  const ModelComparisonRow* best = nullptr;
  for (const auto& compared : comparison)
    if (!compared.model.arm.rows.empty() && std::isfinite(compared.heldout.rms) &&
        (!best || compared.heldout.rms < best->heldout.rms))
      best = &compared;
  return best;
}

void takeAsRealArm(const ModelComparisonRow& best, RealArm& real) {
  real.cell.arm = best.model.arm;
  real.cell.X_WB = best.model.base_poses.back().X_WB;
  real.name = best.name + ", with an unmodelled error as large as the noise floor";
  real.unmodelled = std::isfinite(best.noise_floor) ? best.noise_floor / std::sqrt(3.) : 0;
}

LadderSteps addStepTables(RealArm real, int holes, std::uint64_t seed, std::vector<ModelComparisonRow>& comparison,
                          const WorkHooks& hooks) {
  LadderSteps steps;
  steps.real = std::move(real);
  beginStep(hooks, "steps of the tool", 0, comparison.size() + 1);
  const StepHoles drawn = drawStepHoles(steps.real, holes, seed, hooks.stop);
  steps.holes = static_cast<int>(drawn.holes.size());
  steps.out_of_reach = drawn.out_of_reach;
  if (drawn.holes.empty()) steps.reason = "the real arm reaches no hole of the sheet";
  for (std::size_t k = 0; k < comparison.size() && steps.reason.empty(); ++k) {
    beginStep(hooks, "steps of the tool", k + 1, comparison.size() + 1);
    const auto& model = comparison[k].model;
    auto& table = comparison[k].steps.emplace();
    if (model.arm.rows.empty())
      table.reason = "the model could not be fitted";
    else
      table = stepTableOf(model.arm, model.base_poses.back().X_WB, steps.real, drawn, hooks.stop);
  }
  throwIfJobStopped(hooks);
  return steps;
}

}  // namespace tubeplan::app
