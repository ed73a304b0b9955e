#include "app/documents/pose_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/documents/figures.hpp"
#include "app/files/joint_units.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

PoseFigures poseFiguresOf(const deflection::PoseOf<double>& X) { return {X.p, deflection::fixedAnglesOf(X.R)}; }

PoseFigures poseChange(const deflection::FlexibleKinematics& shape) {
  const PoseFigures rigid = poseFiguresOf(shape.X_BT), flexible = poseFiguresOf(shape.X_BD);
  PoseFigures change{flexible.position - rigid.position, flexible.angles - rigid.angles};
  for (int k = 0; k < 3; ++k) change.angles[k] = std::remainder(change.angles[k], 2 * std::numbers::pi);
  return change;
}

nlohmann::json figuresJson(const PoseFigures& figures, const Units& units) {
  return {{"position", vectorJson(figures.position, units, dimension::kLength)},
          {"fixed_angles", vectorJson(figures.angles, units, dimension::kAngle)}};
}

nlohmann::json poseFiguresJson(const deflection::FlexibleKinematics& shape, const Units& units) {
  return {{"rigid", figuresJson(poseFiguresOf(shape.X_BT), units)},
          {"flexible", figuresJson(poseFiguresOf(shape.X_BD), units)},
          {"change", figuresJson(poseChange(shape), units)},
          {"iterations", shape.iterations}};
}

nlohmann::json jointValuesJson(const Eigen::VectorXd& q, const Cell& cell) {
  const Eigen::VectorXd values = q.cwiseQuotient(jointFactors(cell.arm, cell.units));
  return std::vector<double>(values.begin(), values.end());
}

nlohmann::json poseJson(const Eigen::Isometry3d& X, const Units& units) {
  const Eigen::Vector3d rpy = deflection::fixedAnglesOf(X.linear());
  return {{"position", vectorJson(X.translation(), units, dimension::kLength)},
          {"rpy", vectorJson(rpy, units, dimension::kAngle)}};
}

}  // namespace tubeplan::app
