// Flexible inverse kinematics: joint readings that bring the deflected tip to a goal (Calkins 1994, sections 4.2, 4.3).
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection {

struct InverseKinematicsOptions {
  double position_tolerance = 1e-10;  ///< tolerance of the deflected tip [m]
  double pitch_tolerance = 1e-10;     ///< tolerance of the tilt that the joints can still reduce [rad]
  int max_iterations = 60;
  /// Least singular value of the scaled Jacobian (tip motion per reach, and pitch of turret arms, per rad). For other
  /// arms, a tilt that the joints change by less per rad is accepted.
  double singular_floor = 0.01;
  /// Largest angle between tool and goal axis [rad]; branches with more are refused.
  double max_tilt = std::numbers::pi / 2;
  int lattice_starts = 256;  ///< starts of the rigid search without a closed solution
  int most_branches = 48;    ///< number of lattice starts, as different as possible, that are followed further
  FlexibleKinematicsOptions kinematics{1e-13, 100};
};

enum class BranchStatus { kNotRun, kConverged, kOutOfReach, kPastJointLimit, kSingular, kNotConverged, kTiltTooLarge };

const char* nameOf(BranchStatus status);

/// One solution of a goal. The joint vector is usable only if `status` is kConverged; otherwise it is the last one
/// tried.
struct Branch {
  BranchStatus status = BranchStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd q;                                                 ///< joint readings
  double position_error = std::numeric_limits<double>::quiet_NaN();  ///< [m]
  double tilt = std::numeric_limits<double>::quiet_NaN();  ///< remaining angle between tool axis and goal axis [rad]
  double smallest_singular_value = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
};

struct InverseKinematics {
  BranchStatus status = BranchStatus::kNotRun;  ///< kConverged if any branch is; else the most informative failure
  std::string reason;
  std::vector<Branch> branches;  ///< all branches, converged ones first, in a fixed order
};

/// Returns all branches: rigid ones (closed forms of turrets and wrists, else roots of the chain's closure), each led
/// to the goal on the flexible arm. The deflected tip is at its place, and the tilt is the least that the joints allow
/// there. Any remaining freedom brings joints back within their limits.
[[nodiscard]] InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load,
                                                       const Eigen::Vector3d& gravity_B,
                                                       const InverseKinematicsOptions& options = {});

/// Returns one branch from a start near it, such as that of a via point from its neighbour.
[[nodiscard]] Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Eigen::Vector3d& gravity_B,
                                  const Eigen::VectorXd& start, const InverseKinematicsOptions& options = {});

}  // namespace tubeplan::deflection
