// What an arm's joints are solved for at a goal: how far a posture is from it, and how that changes with the joints.
// Internal to the inverse.
#pragma once

#include <functional>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

/// The tip and its motion at each column of q [rad, m], of the arm as it is or rigid.
using PlaceTips = std::function<void(const Eigen::Ref<const Eigen::MatrixXd>& q, std::span<TipMotion> tips)>;

/// The deflected tip under a load. `arm` must outlive it.
[[nodiscard]] PlaceTips deflectedTips(const Arm& arm, bool turret, double load, const Eigen::Vector3d& gravity_B,
                                      const FlexibleKinematicsOptions& options);
/// The tip of the rigid arm. `axes` must outlive it.
[[nodiscard]] PlaceTips rigidTips(const AxesAtZero& axes);

/// Of up to three equations, by scaled joints.
using GoalSlopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, Eigen::Dynamic>;
using GoalSides = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// How far a posture is from its goal, and the slopes by scaled joints (rad; slides as shares of the reach).
struct GoalResidual {
  GoalSides off;   ///< place, 3, as a share of the reach
  GoalSides lean;  ///< [rad] what is to vanish or be least: of a turret arm the pitch about its last joint, 1; of
                   ///< others the turn between the axes, 2
  GoalSlopes by_off, by_lean;
  double position_error = 0, tilt = 0;  ///< m, rad

  [[nodiscard]] bool isFinite() const { return off.allFinite() && lean.allFinite() && by_off.allFinite(); }
};

/// What is solved: the arm's numbers that no goal changes.
class GoalProblem {
 public:
  /// `options` must outlive this.
  GoalProblem(const Arm& arm, bool turret, PlaceTips place, const InverseKinematicsOptions& options);

  void place(const Eigen::Ref<const Eigen::MatrixXd>& q, std::span<TipMotion> tips) { place_(q, tips); }
  /// Of a tip as placed; its columns are scaled in passing.
  void evaluate(const ToolGoal& goal, TipMotion& tip, GoalResidual& residual) const;

  /// Scaled, how far the k-th reading is past a place just within its limits, whole turns aside; zero where it is
  /// within.
  [[nodiscard]] double pastLimit(Eigen::Index k, double reading) const;
  [[nodiscard]] double mostPastLimits(const Eigen::Ref<const Eigen::VectorXd>& q) const;

  [[nodiscard]] bool isTurret() const { return turret_; }
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }  ///< rad or m for one of a scaled joint
  [[nodiscard]] const InverseKinematicsOptions& options() const { return options_; }

 private:
  bool turret_;
  PlaceTips place_;
  const InverseKinematicsOptions& options_;
  double reach_;
  Eigen::VectorXd scale_, lower_, upper_;
};

}  // namespace tubeplan::deflection
