// Rigid postures for the goals of one arm, from which the flexible solution sets out; what no goal changes is worked
// out once. Internal to the inverse.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/goal_newton.hpp"

namespace tubeplan::deflection {

class StartPostures {
 public:
  /// `arm` must outlive this.
  StartPostures(const Arm& arm, const InverseKinematicsOptions& options);
  StartPostures(const StartPostures&) = delete;
  StartPostures& operator=(const StartPostures&) = delete;

  [[nodiscard]] bool isTurret() const { return is_turret_; }
  /// Adds what turretBranches() has, or what the search from the lattice finds: none where the place is out of reach.
  void addStarts(const ToolGoal& goal, std::vector<Eigen::VectorXd>& starts);

 private:
  struct Candidate {
    Eigen::VectorXd q;
    double spoilt;  ///< how far past its limits and beyond the largest tilt [scaled, rad]
  };
  [[nodiscard]] std::vector<Candidate> search(const ToolGoal& goal);
  [[nodiscard]] std::vector<Eigen::VectorXd> unlike(std::span<const Candidate> candidates, int most) const;

  AxesAtZero axes_;
  bool is_turret_;
  InverseKinematicsOptions options_;
  GoalProblem rigid_;
  std::vector<Eigen::VectorXd> lattice_;  ///< where the arm is no turret arm
};

}  // namespace tubeplan::deflection
