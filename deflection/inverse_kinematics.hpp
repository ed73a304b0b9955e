// Flexible inverse kinematics: joint readings that bring the deflected tip to a goal (Calkins 1994, sections 4.2, 4.3).
#pragma once

#include <string>
#include <vector>

#include "deflection/rigid_branches.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection {

struct InverseKinematicsOptions {
  double position_tolerance = 1e-10;  ///< m, of the deflected tip
  double pitch_tolerance = 1e-10;     ///< rad, of the tool's axis about the last joint (turret arms)
  int max_iterations = 60;
  double singular_floor =
      0.01;                 ///< least singular value of the scaled Jacobian (tip motion per reach and pitch, per rad)
  int lattice_starts = 64;  ///< for arms without closed form
  double position_weight = 1;  ///< least-squares pose of other arms: 1 per m ...
  double axis_weight = 0.05;   ///< ... against this per rad of tilt of the tool's axis
  FlexibleKinematicsOptions kinematics{1e-13, 100};
};

enum class BranchStatus { kNotRun, kConverged, kOutOfReach, kPastJointLimit, kSingular, kNotConverged };

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

/// All branches: rigid solutions (closed form for turret arms, lattice otherwise), each refined on the flexible model
/// by damped Newton.
[[nodiscard]] InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load,
                                                       const Eigen::Vector3d& gravity_B,
                                                       const InverseKinematicsOptions& options = {});

/// One branch, from a start near it: a via point from its neighbour. Turret arms meet position and pitch exactly; other
/// arms minimise the weighted pose error.
[[nodiscard]] Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Eigen::Vector3d& gravity_B,
                                  const Eigen::VectorXd& start, const InverseKinematicsOptions& options = {});

}  // namespace tubeplan::deflection
