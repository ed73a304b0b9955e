#include "calibration/simulation/simulated_touch.hpp"

#include "calibration/random_stream.hpp"
#include "deflection/inverse/inverse_solver.hpp"

namespace tubeplan::calibration {

namespace {

Eigen::VectorXd encoderNoise(const deflection::Arm& arm, RandomStream& random) {
  Eigen::VectorXd noise(arm.jointCount());
  for (int k = 0; k < noise.size(); ++k) noise[k] = random.normal(arm.joint(k).encoder_sigma);
  return noise;
}

}  // namespace

std::vector<deflection::Branch> reachPlaces(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const std::vector<Eigen::Vector3d>& places_W,
                                            const std::vector<Eigen::VectorXd>& starts, double load,
                                            const Eigen::Vector3d& axis_W) {
  std::vector<deflection::ToolGoal> goals;
  for (const auto& place_W : places_W) goals.push_back({X_WB.inverse() * place_W, X_WB.linear().transpose() * axis_W});
  deflection::InverseSolver solver(arm, load, deflection::gravityInBase(arm, X_WB));
  return solver.refine(goals, starts);
}

Measurement plannedTouch(const TouchPlan& plan, const Eigen::VectorXd& q, double load, double sigma) {
  Measurement touch;
  touch.id = plan.id;
  touch.kind = MeasurementKind::kTouch;
  touch.point = plan.hole;
  touch.p_W = plan.p_WH;
  touch.q = q;
  touch.load = load;
  touch.sigma = sigma;
  return touch;
}

TouchSimulation simulateTouches(const deflection::Arm& truth, const Eigen::Isometry3d& X_WB,
                                const std::vector<TouchPlan>& plans, const TouchSimulationOptions& options) {
  TouchSimulation result;
  RandomStream random(options.seed);
  std::vector<Eigen::Vector3d> tips_W;
  std::vector<Eigen::VectorXd> starts, measurement_noise;
  for (const auto& plan : plans) {
    const Eigen::Vector3d touch = random.vector(options.sigma), beyond = random.vector(options.model_error_sigma);
    tips_W.push_back(plan.p_WH + touch + beyond);
    starts.push_back(plan.q_start);
    measurement_noise.push_back(encoderNoise(truth, random));
  }
  const auto branches = reachPlaces(truth, X_WB, tips_W, starts, options.load, options.axis_W);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const auto& plan = plans[k];
    if (branches[k].status != deflection::BranchStatus::kConverged) {
      result.status = TouchSimulationStatus::kOutOfReach;
      result.reason = "hole " + plan.hole + " cannot be touched by the true arm: " + branches[k].reason;
      return result;
    }
    result.touches.push_back(plannedTouch(plan, branches[k].q + measurement_noise[k], options.load, options.sigma));
  }
  result.status = TouchSimulationStatus::kDone;
  return result;
}

}  // namespace tubeplan::calibration
