#include "calibration/simulated_touch.hpp"

#include <random>

namespace tubeplan::calibration {

namespace {

Eigen::Vector3d gaussian(std::mt19937_64& random, double sigma) {
  std::normal_distribution<double> normal(0, 1);
  Eigen::Vector3d v;
  for (int k = 0; k < 3; ++k) v[k] = sigma * normal(random);
  return v;
}

Eigen::VectorXd encoderNoise(const deflection::Arm& arm, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, 1);
  const auto active = deflection::activeRows(arm);
  Eigen::VectorXd noise(active.size());
  for (int k = 0; k < noise.size(); ++k) noise[k] = arm.rows[active[k]].joint.encoder_sigma * normal(random);
  return noise;
}

}  // namespace

TouchSimulation simulateTouches(const deflection::Arm& truth, const Eigen::Isometry3d& X_WB,
                                const std::vector<TouchPlan>& plans, const TouchSimulationOptions& options) {
  TouchSimulation result;
  std::mt19937_64 random(options.seed);
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(truth, X_WB);
  for (const auto& plan : plans) {
    const Eigen::Vector3d tip_W =
        plan.p_WH + gaussian(random, options.sigma) + gaussian(random, options.model_error_sigma);
    const deflection::ToolGoal goal{X_WB.inverse() * tip_W, X_WB.linear().transpose() * options.axis_W};
    const auto branch = deflection::refineBranch(truth, goal, options.load, gravity_B, plan.q_start);
    if (branch.status != deflection::BranchStatus::kConverged) {
      result.status = TouchSimulationStatus::kOutOfReach;
      result.reason = "hole " + plan.hole + " cannot be touched by the true arm: " + branch.reason;
      return result;
    }
    result.touches.push_back(
        {plan.id, plan.hole, plan.p_WH, branch.q + encoderNoise(truth, random), options.load, options.sigma, {}});
  }
  result.status = TouchSimulationStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
