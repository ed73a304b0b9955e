// Flexible inverse kinematics: joint readings that bring the deflected tip to a goal (Calkins 1994, sections 4.2, 4.3).
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection {

struct InverseKinematicsOptions {
  double position_tolerance = 1e-10;  ///< m, of the deflected tip
  double pitch_tolerance = 1e-10;     ///< rad, of what the joints can still take from the tool's tilt
  int max_iterations = 60;
  /// Least singular value of the scaled Jacobian (tip motion per reach, and pitch of turret arms, per rad); of other
  /// arms, tilt that the joints change by less per rad is taken as it comes.
  double singular_floor = 0.01;
  double max_tilt = std::numbers::pi / 2;  ///< rad between tool and goal axis; a branch with more is refused
  int lattice_starts = 256;                ///< of the rigid search, where no closure is solved
  int most_branches = 48;                  ///< ... of which so many go on, as unlike each other as may be
  FlexibleKinematicsOptions kinematics{1e-13, 100};
};

enum class BranchStatus { kNotRun, kConverged, kOutOfReach, kPastJointLimit, kSingular, kNotConverged, kTiltTooLarge };

const char* nameOf(BranchStatus status);

/// One way of reaching the goal. The joint vector is usable only when `status` is kConverged; otherwise it is the last
/// tried.
struct Branch {
  BranchStatus status = BranchStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd q;                                                 ///< joint readings
  double position_error = std::numeric_limits<double>::quiet_NaN();  ///< m
  double tilt = std::numeric_limits<double>::quiet_NaN();            ///< rad between tool axis and goal axis that stays
  double smallest_singular_value = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
};

struct InverseKinematics {
  BranchStatus status = BranchStatus::kNotRun;  ///< kConverged when any branch is; else the most telling failure
  std::string reason;
  std::vector<Branch> branches;  ///< converged ones first, in a fixed order
};

/// All branches: rigid ones (closed forms of turrets and wrists, else roots of the chain's closure), each led to the
/// goal on the flexible arm. The deflected tip is at its place; the tilt is the least that the joints can then make of
/// it; what freedom is left brings joints back within their limits.
[[nodiscard]] InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load,
                                                       const Eigen::Vector3d& gravity_B,
                                                       const InverseKinematicsOptions& options = {});

/// One branch, from a start near it: a via point from its neighbour.
[[nodiscard]] Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Eigen::Vector3d& gravity_B,
                                  const Eigen::VectorXd& start, const InverseKinematicsOptions& options = {});

}  // namespace tubeplan::deflection
