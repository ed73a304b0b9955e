// The shipped mock-up cell for tests, and modified copies of the cell.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "app/formats/cell/workcell.hpp"
#include "planner/visit_plan.hpp"
#include "tests/planner/toy_arm.hpp"
#include "tests/units.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::planner::testing {

inline Workcell mockup(const std::string& file = "mockup.yaml") {
  return app::workcellOf(app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/" + file), "test the planner");
}

inline std::vector<int> tubesOf(const Workcell& cell, const std::string& request) {
  return tubesheets::selectTubes(cell.sheet, request).tube_indices;
}

inline Eigen::Vector3d holeOf(const Workcell& cell, int tube) {
  return holeCentre(cell.sheet.tubes.at(static_cast<std::size_t>(tube)));
}

/// Returns an obstacle from dimensions in inches (the scale of direction vectors does not matter).
inline Obstacle obstacleInInches(const std::string& name, const char* key, std::vector<double> numbers) {
  for (double& number : numbers) number *= kInch;
  if (std::string(key) == "box") numbers.resize(9, 0.0);
  return {name, shape(key, numbers), {}};
}

inline Workcell withObstacle(Workcell cell, Obstacle obstacle) {
  std::erase_if(cell.scene.obstacles, [&](const Obstacle& other) { return other.name == obstacle.name; });
  cell.scene.obstacles.push_back(std::move(obstacle));
  return cell;
}

/// Returns the cell without obstacles, in which only the arm's own bodies can collide.
inline Workcell alone(Workcell cell) {
  cell.scene.obstacles.clear();
  for (auto& body : cell.scene.bodies) body.allow.clear();
  return cell;
}

/// Returns a random posture within the joints' limits, whether or not it collides.
inline Eigen::VectorXd randomPosture(const deflection::Arm& arm, std::mt19937_64& generator) {
  Eigen::VectorXd q(arm.jointCount());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const auto& joint = arm.joint(j);
    q[j] = uniform(generator, joint.lower, joint.upper);
  }
  return q;
}

inline bool withinLimits(const deflection::Arm& arm, const Eigen::VectorXd& q) {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const auto& joint = arm.joint(j);
    if (!(q[j] >= joint.lower - 1e-12 && q[j] <= joint.upper + 1e-12)) return false;
  }
  return true;
}

/// Returns the tip position of the deflected arm according to the kinematics [m].
inline Eigen::Vector3d deflectedTip(const Workcell& cell, const Eigen::VectorXd& q) {
  const auto shape = deflection::solveFlexibleKinematics(
      cell.arm, {q, cell.load, deflection::gravityInBase(cell.arm, cell.X_WB)}, {1e-14, 200});
  return cell.X_WB * shape.X_BD.p;
}

inline Workcell rigid(Workcell cell) {
  cell.arm = deflection::rigidCopy(cell.arm);
  return cell;
}

inline double sideways(const Eigen::Vector3d& p, const Eigen::Vector3d& hole) { return (p - hole).head<2>().norm(); }

}  // namespace tubeplan::planner::testing
