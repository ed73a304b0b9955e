// The Cobra arm under the mock-up's tube sheet, and simulated touches of its holes.
#pragma once

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {

struct TouchedCell {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB_nominal, X_WB_true;
  std::vector<TouchPlan> plans;
};

inline Eigen::Isometry3d pose(double x, double y, double z, double roll, double pitch, double yaw) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = Eigen::Vector3d(x, y, z) * kInch;
  X.linear() = deflection::rotationFromFixedAngles<double>(Eigen::Vector3d(roll, pitch, yaw) * kDegree);
  return X;
}

/// Returns the mock-up cell with touches planned at the given hole positions [in], at postures with the elbow up.
inline TouchedCell touchedCell(const std::vector<std::pair<double, double>>& holes = {{-40, 10}, {38, 12}, {10, 45}}) {
  static const app::Cell kCell = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml");
  TouchedCell cell{kCell.arm, kCell.X_WB, pose(0.8, 42.4, -43.5, 0.3, -0.2, -89), {}};
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(cell.arm, cell.X_WB_nominal);
  for (const auto& [x, y] : holes) {
    const Eigen::Vector3d hole = Eigen::Vector3d(x, y, 0) * kInch;
    const deflection::ToolGoal goal{cell.X_WB_nominal.inverse() * hole, Eigen::Vector3d::UnitZ()};
    const auto branches = deflection::solveInverseKinematics(cell.arm, goal, 0, gravity_B).branches;
    const std::string id = "T" + std::to_string(cell.plans.size() + 1);
    cell.plans.push_back({id, "H" + std::to_string(cell.plans.size() + 1), hole, branches.front().q});
  }
  return cell;
}

/// Returns a copy of the arm whose parameters are drawn at random from their uncertainty.
inline deflection::Arm drawnArm(const deflection::Arm& arm, const ArmUncertainty& uncertainty, std::uint64_t seed) {
  const UncertainNumbers numbers = uncertainNumbers(arm, uncertainty);
  RandomStream random(seed * 7919 + 1);
  Eigen::VectorXd z(numbers.root.cols());
  for (double& value : z) value = random.normal(1);
  const Eigen::VectorXd values = numbers.root * z;
  deflection::Arm drawn = arm;
  for (std::size_t k = 0; k < numbers.unknowns.size(); ++k)
    deflection::locate(drawn, numbers.unknowns[k].path) =
        valueAt(numbers.unknowns[k], values[static_cast<Eigen::Index>(k)]);
  return drawn;
}

/// Returns touches by the arm at its true base pose with noise `sigma_in` [in]; 0 gives exact touches with a stated
/// sigma of 0.005 in.
inline std::vector<Measurement> touchesOf(const TouchedCell& cell, double sigma_in, std::uint64_t seed) {
  deflection::Arm truth = cell.arm;
  if (sigma_in == 0)
    for (auto& row : truth.rows) row.joint.encoder_sigma = 0;
  TouchSimulationOptions options;
  options.sigma = sigma_in * kInch;
  options.seed = seed;
  auto touches = simulateTouches(truth, cell.X_WB_true, cell.plans, options).touches;
  for (auto& touch : touches) touch.sigma = (sigma_in == 0 ? 0.005 : sigma_in) * kInch;
  return touches;
}

}  // namespace tubeplan::calibration
