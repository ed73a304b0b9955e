// Postures of the rigid arm at the goals, from which the flexible solution starts. Values that do not depend on the
// goal are computed once. Internal to the inverse kinematics.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deflection/inverse/goal_problem.hpp"
#include "deflection/inverse/rigid_search.hpp"

namespace tubeplan::deflection {

class StartPostures {
 public:
  /// `arm` must outlive this object.
  StartPostures(const Arm& arm, const InverseKinematicsOptions& options);
  StartPostures(const StartPostures&) = delete;
  StartPostures& operator=(const StartPostures&) = delete;

  [[nodiscard]] bool isTurret() const { return is_turret_; }
  /// Adds the postures of turretBranches() or RigidSearch; adds nothing if the goal position is out of reach.
  void addStarts(const ToolGoal& goal, std::vector<Eigen::VectorXd>& starts);

 private:
  struct Candidate {
    Eigen::VectorXd q;
    /// Penalty: excess over the joint limits [rad or fraction of the reach] plus excess over the largest tilt [rad].
    double penalty;
  };
  [[nodiscard]] std::vector<Candidate> search(const ToolGoal& goal);
  [[nodiscard]] std::vector<Candidate> within(const ToolGoal& goal, std::span<const Eigen::VectorXd> starts);
  /// Iterates from each start to the goal. Sets `candidates` to the postures that meet the goal or, if there are none,
  /// to the postures that end near it. Returns true if any posture meets it.
  bool iterateAll(const ToolGoal& goal, std::span<const Eigen::VectorXd> starts, std::vector<Candidate>& candidates);
  [[nodiscard]] std::vector<Eigen::VectorXd> distinct(std::span<const Candidate> candidates, int most) const;

  const Arm& arm_;
  AxesAtZero axes_;
  bool is_turret_;
  InverseKinematicsOptions options_;
  GoalProblem rigid_;
  std::optional<RigidSearch> postures_, places_;  ///< searches, created on first use
};

}  // namespace tubeplan::deflection
