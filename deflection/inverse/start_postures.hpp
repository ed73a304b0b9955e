// Rigid postures for the goals of one arm, from which the flexible solution sets out; what no goal changes is worked
// out once. Internal to the inverse.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deflection/inverse/goal_problem.hpp"
#include "deflection/inverse/rigid_search.hpp"

namespace tubeplan::deflection {

class StartPostures {
 public:
  /// `arm` must outlive this.
  StartPostures(const Arm& arm, const InverseKinematicsOptions& options);
  StartPostures(const StartPostures&) = delete;
  StartPostures& operator=(const StartPostures&) = delete;

  [[nodiscard]] bool isTurret() const { return is_turret_; }
  /// Adds what turretBranches() has, or what RigidSearch finds: none where the place is out of reach.
  void addStarts(const ToolGoal& goal, std::vector<Eigen::VectorXd>& starts);

 private:
  struct Candidate {
    Eigen::VectorXd q;
    double spoilt;  ///< how far past its limits and beyond the largest tilt [scaled, rad]
  };
  [[nodiscard]] std::vector<Candidate> search(const ToolGoal& goal);
  [[nodiscard]] std::vector<Candidate> within(const ToolGoal& goal, std::span<const Eigen::VectorXd> starts);
  /// Each start led to its goal; false where none meets it, and they are only near.
  bool leadAll(const ToolGoal& goal, std::span<const Eigen::VectorXd> starts, std::vector<Candidate>& candidates);
  [[nodiscard]] std::vector<Eigen::VectorXd> unlike(std::span<const Candidate> candidates, int most) const;

  const Arm& arm_;
  AxesAtZero axes_;
  bool is_turret_;
  InverseKinematicsOptions options_;
  GoalProblem rigid_;
  std::optional<RigidSearch> postures_, places_;  ///< made when they are asked for
};

}  // namespace tubeplan::deflection
