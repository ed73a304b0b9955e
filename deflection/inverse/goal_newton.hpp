// One goal met by steps, for whatever arm. What holds and what is least has an order: the tip's place; then the tool's
// lean against the goal's axis, as far as the joints can change it with the place held; then, with what is still free,
// the limits of the joints. Internal to the inverse.
#pragma once

#include <functional>
#include <memory>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

/// The tip and its motion at readings, of the arm as it is or rigid.
using PlaceTip = std::function<void(const Eigen::VectorXd& q, TipMotion& tip)>;

/// The deflected tip under a load.
[[nodiscard]] PlaceTip deflectedTip(const Arm& arm, double load, const Eigen::Vector3d& gravity_B,
                                    const FlexibleKinematicsOptions& options);

/// How far a posture is from its goal, and the slopes by scaled joints (rad; slides as shares of the reach).
struct GoalResidual {
  Eigen::VectorXd off;   ///< place, 3, as a share of the reach
  Eigen::VectorXd lean;  ///< [rad] what is to vanish or be least: of a turret arm the pitch about its last joint, 1; of
                         ///< others the turn between the axes, 2
  Eigen::MatrixXd by_off;  ///< slopes of both
  Eigen::MatrixXd by_lean;
  double position_error = 0, tilt = 0;  ///< m, rad

  [[nodiscard]] bool isFinite() const { return off.allFinite() && lean.allFinite() && by_off.allFinite(); }
};

/// What is solved: the arm's numbers that no goal changes.
class GoalProblem {
 public:
  /// `options` must outlive this.
  GoalProblem(const Arm& arm, bool turret, PlaceTip place, const InverseKinematicsOptions& options);

  void evaluate(const ToolGoal& goal, const Eigen::VectorXd& q, GoalResidual& residual);

  /// Scaled, how far each reading is past a place just within its limits, whole turns aside; zero where it is within.
  [[nodiscard]] Eigen::VectorXd pastLimits(const Eigen::VectorXd& q) const;

  [[nodiscard]] bool isTurret() const { return turret_; }
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }  ///< rad or m for one of a scaled joint
  [[nodiscard]] const InverseKinematicsOptions& options() const { return options_; }

 private:
  bool turret_;
  PlaceTip place_;
  const InverseKinematicsOptions& options_;
  double reach_;
  Eigen::VectorXd scale_, lower_, upper_;
  TipMotion tip_;
};

/// Newton where the place is concerned, Gauss-Newton for the lean that stays; shortened while it leads away.
[[nodiscard]] Branch leadToGoal(GoalProblem& problem, const ToolGoal& goal, Eigen::VectorXd q);

}  // namespace tubeplan::deflection
