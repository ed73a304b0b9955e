// Flexible inverse kinematics for many goals of one arm: made ready once, goals and branches solved side by side.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"

namespace tubeplan::deflection {

/// How many branches a goal can have at the most.
[[nodiscard]] int mostBranches(const Arm& arm, const InverseKinematicsOptions& options);

/// Solves goals of one arm under one load; each thread needs its own. A goal's solution has the same bits whatever is
/// solved with it.
class InverseSolver {
 public:
  /// `arm` must outlive this, and stay as it is.
  InverseSolver(const Arm& arm, double load, const Eigen::Vector3d& gravity_B,
                const InverseKinematicsOptions& options = {});
  InverseSolver(const InverseSolver&) = delete;
  InverseSolver& operator=(const InverseSolver&) = delete;
  ~InverseSolver();

  /// All branches of each goal, as solveInverseKinematics() has them.
  [[nodiscard]] std::vector<InverseKinematics> solve(std::span<const ToolGoal> goals);
  [[nodiscard]] InverseKinematics solve(const ToolGoal& goal);

  /// One branch for each goal, from a start near it, as refineBranch() has it.
  [[nodiscard]] std::vector<Branch> refine(std::span<const ToolGoal> goals, std::span<const Eigen::VectorXd> starts);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tubeplan::deflection
