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
  /// Smallest allowed singular value of the scaled Jacobian, whose rows are the tip's motion as a fraction of the reach
  /// and, for turret arms, the pitch, per rad. On other arms, tilt is not reduced in directions in which the joints
  /// change it by less than this value per rad.
  double singular_floor = 0.01;
  /// Largest allowed angle between tool axis and goal axis [rad]; branches with a larger angle get kTiltTooLarge.
  double max_tilt = std::numbers::pi / 2;
  int lattice_starts = 256;  ///< number of start postures for arms without a closed form or closure equations
  /// Largest number of distinct rigid postures, within or near the joint limits, from which the flexible solution is
  /// started.
  int most_branches = 48;
  FlexibleKinematicsOptions kinematics{1e-13, 100};
};

enum class BranchStatus { kNotRun, kConverged, kOutOfReach, kPastJointLimit, kSingular, kNotConverged, kTiltTooLarge };

const char* nameOf(BranchStatus status);

/// One solution of a goal. The joint vector is usable only if `status` is kConverged; otherwise it is the last joint
/// vector tried.
struct Branch {
  BranchStatus status = BranchStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd q;                                                 ///< joint readings [rad, m]
  double position_error = std::numeric_limits<double>::quiet_NaN();  ///< distance of the tip from the goal [m]
  double tilt = std::numeric_limits<double>::quiet_NaN();  ///< remaining angle between tool axis and goal axis [rad]
  double smallest_singular_value = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
};

struct InverseKinematics {
  /// kConverged if a branch converged; otherwise the most informative failure.
  BranchStatus status = BranchStatus::kNotRun;
  std::string reason;
  std::vector<Branch> branches;  ///< all branches, converged branches first, in a fixed order
};

/// Returns all branches: rigid solutions (closed forms for turrets and wrists, else roots of the chain's closure
/// equations), each led to the goal on the flexible arm. The deflected tip is at the goal position, and the tilt is the
/// smallest that the joints allow there. Any remaining freedom brings joints back within their limits.
[[nodiscard]] InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load,
                                                       const Eigen::Vector3d& gravity_B,
                                                       const InverseKinematicsOptions& options = {});

/// Returns the branch reached from a nearby start posture, for example from a neighbouring via point.
[[nodiscard]] Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Eigen::Vector3d& gravity_B,
                                  const Eigen::VectorXd& start, const InverseKinematicsOptions& options = {});

}  // namespace tubeplan::deflection
