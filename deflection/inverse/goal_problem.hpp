// Goal equations of an arm: the residual of a posture at a goal, and its derivatives with respect to the joints.
// Internal to the inverse kinematics.
#pragma once

#include <functional>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

/// Function that computes the tip and its derivatives for the readings in each column of q [rad, m], on the flexible or
/// the rigid arm.
using PlaceTips = std::function<void(const Eigen::Ref<const Eigen::MatrixXd>& q, std::span<TipMotion> tips)>;

/// Returns the function that computes the deflected tip under a load [N]. `arm` must outlive the function.
[[nodiscard]] PlaceTips deflectedTips(const Arm& arm, bool turret, double load, const Eigen::Vector3d& gravity_B,
                                      const FlexibleKinematicsOptions& options);
/// Returns the function that computes the tip of the rigid arm. `axes` must outlive the function.
[[nodiscard]] PlaceTips rigidTips(const AxesAtZero& axes);

/// Derivatives of up to three equations with respect to the scaled joints of GoalResidual.
using GoalSlopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, Eigen::Dynamic>;
using GoalSides = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// Residual of a posture at its goal, and its derivatives with respect to scaled joints (revolute joints in rad,
/// prismatic joints as fractions of the reach).
struct GoalResidual {
  GoalSides off;  ///< residual of the position as a fraction of the reach, 3 rows
  /// Residual of the tool's direction [rad]: for a turret arm the pitch about its last joint, 1 row; for other arms the
  /// rotation between tool axis and goal axis, 2 rows.
  GoalSides lean;
  GoalSlopes by_off, by_lean;
  double position_error = 0, tilt = 0;  ///< distance from the goal [m], angle to its axis [rad]

  [[nodiscard]] bool isFinite() const { return off.allFinite() && lean.allFinite() && by_off.allFinite(); }
};

/// The goal equations of one arm. Values that do not depend on the goal are computed once.
class GoalProblem {
 public:
  /// `options` must outlive this object.
  GoalProblem(const Arm& arm, bool turret, PlaceTips place, const InverseKinematicsOptions& options);

  void place(const Eigen::Ref<const Eigen::MatrixXd>& q, std::span<TipMotion> tips) { place_(q, tips); }
  /// Computes the residual of a tip; converts `tip.columns` to scaled joints in place.
  void evaluate(const ToolGoal& goal, TipMotion& tip, GoalResidual& residual) const;

  /// Returns the signed distance of the k-th reading beyond its nearer limit (negative below the lower limit), plus a
  /// small margin, divided by scale(). The reading is wrapped by whole turns first. Zero if it is within the limits.
  [[nodiscard]] double pastLimit(Eigen::Index k, double reading) const;
  [[nodiscard]] double mostPastLimits(const Eigen::Ref<const Eigen::VectorXd>& q) const;

  [[nodiscard]] bool isTurret() const { return turret_; }
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }  ///< rad or m per unit of a scaled joint
  [[nodiscard]] const InverseKinematicsOptions& options() const { return options_; }

 private:
  bool turret_;
  PlaceTips place_;
  const InverseKinematicsOptions& options_;
  double reach_;
  Eigen::VectorXd scale_, lower_, upper_;
};

}  // namespace tubeplan::deflection
