// The equations that an arm's joints must solve at a goal: residual of a posture and its slopes by the joints. Internal
// to the inverse.
#pragma once

#include <functional>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

/// Computes the tip and its motion at each column of q [rad, m], for the true or the rigid arm.
using PlaceTips = std::function<void(const Eigen::Ref<const Eigen::MatrixXd>& q, std::span<TipMotion> tips)>;

/// Returns the function for the deflected tip under a load. `arm` must outlive it.
[[nodiscard]] PlaceTips deflectedTips(const Arm& arm, bool turret, double load, const Eigen::Vector3d& gravity_B,
                                      const FlexibleKinematicsOptions& options);
/// Returns the function for the tip of the rigid arm. `axes` must outlive it.
[[nodiscard]] PlaceTips rigidTips(const AxesAtZero& axes);

/// Slopes of up to three equations by scaled joints.
using GoalSlopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, Eigen::Dynamic>;
using GoalSides = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// Residual of a posture at its goal, and the slopes by scaled joints (rad; slides as shares of the reach).
struct GoalResidual {
  GoalSides off;  ///< residual of the place as a share of the reach, 3 rows
  /// Residual of the tool's direction [rad]: for a turret arm the pitch about its last joint, 1 row; for others the
  /// rotation between the axes, 2 rows.
  GoalSides lean;
  GoalSlopes by_off, by_lean;
  double position_error = 0, tilt = 0;  ///< [m], [rad]

  [[nodiscard]] bool isFinite() const { return off.allFinite() && lean.allFinite() && by_off.allFinite(); }
};

/// Numbers of the arm that do not depend on the goal.
class GoalProblem {
 public:
  /// `options` must outlive this object.
  GoalProblem(const Arm& arm, bool turret, PlaceTips place, const InverseKinematicsOptions& options);

  void place(const Eigen::Ref<const Eigen::MatrixXd>& q, std::span<TipMotion> tips) { place_(q, tips); }
  /// Computes the residual of a tip; scales its columns in place.
  void evaluate(const ToolGoal& goal, TipMotion& tip, GoalResidual& residual) const;

  /// Returns the scaled distance of the k-th reading beyond a value just within its limits, less whole turns; zero if
  /// it is within.
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
