#include "app/studies/monte_carlo/true_touches.hpp"

namespace tubeplan::app {

using calibration::Measurement, calibration::TouchPlan;

std::vector<Measurement> touchHoles(const planner::Workcell& truth, const std::vector<TrialHole>& holes, int count,
                                    double sigma, std::uint64_t seed) {
  std::vector<TouchPlan> plans;
  for (int k = 0; k < count; ++k) {
    const auto& hole = holes[static_cast<std::size_t>(k)];
    plans.push_back(hole.plan);
    plans.back().id = "T" + std::to_string(k + 1);
    // Steering compensates the unmodelled tip error: the modelled tip is displaced from the hole by the opposite of
    // this error.
    plans.back().p_WH -= hole.tip_error;
  }
  calibration::TouchSimulationOptions options;
  options.sigma = sigma;
  options.seed = seed;
  auto simulation = calibration::simulateTouches(truth.arm, truth.X_WB, plans, options);
  if (simulation.status != calibration::TouchSimulationStatus::kDone) return {};
  for (int k = 0; k < count; ++k)
    simulation.touches[static_cast<std::size_t>(k)].p_W = holes[static_cast<std::size_t>(k)].plan.p_WH;
  return simulation.touches;
}

bool areWellSpread(const std::vector<TrialHole>& holes, int count) {
  std::vector<Measurement> touches;
  for (int k = 0; k < count; ++k) {
    const TouchPlan& plan = holes[static_cast<std::size_t>(k)].plan;
    touches.push_back(calibration::plannedTouch(plan, plan.q_start, 0, 0));
  }
  calibration::BaseCalibrationOptions options;
  options.collinear_ratio = 0.3;
  return calibration::findTouchProblem(touches, options).empty();
}

}  // namespace tubeplan::app
