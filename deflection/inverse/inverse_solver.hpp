// Flexible inverse kinematics for many goals of one arm, which is prepared once. Goals and branches are solved side by
// side.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"

namespace tubeplan::deflection {

/// Returns an upper bound on the number of branches of a goal, except branches that start far outside joint limits or
/// with far too large a tilt.
[[nodiscard]] int mostBranches(const Arm& arm, const InverseKinematicsOptions& options);

/// Solves goals of one arm under one load; each thread needs its own object. The solution of a goal is bit-identical
/// regardless of the other goals in the call.
class InverseSolver {
 public:
  /// `arm` must outlive this object, and must not change.
  InverseSolver(const Arm& arm, double load, const Eigen::Vector3d& gravity_B,
                const InverseKinematicsOptions& options = {});
  InverseSolver(const InverseSolver&) = delete;
  InverseSolver& operator=(const InverseSolver&) = delete;
  ~InverseSolver();

  /// Returns all branches of each goal, equal to the results of solveInverseKinematics().
  [[nodiscard]] std::vector<InverseKinematics> solve(std::span<const ToolGoal> goals);
  [[nodiscard]] InverseKinematics solve(const ToolGoal& goal);

  /// Returns one branch for each goal, from a start near it, equal to the result of refineBranch().
  [[nodiscard]] std::vector<Branch> refine(std::span<const ToolGoal> goals, std::span<const Eigen::VectorXd> starts);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tubeplan::deflection
