// Flexible forward kinematics: the shape of the arm under its weight and a hung load (Calkins 1994, table 2.1).
//
// Example, compiled and run by tests/examples:
//
//     #include "deflection/flexible_kinematics.hpp"
//     using namespace tubeplan::deflection;
//     Arm arm;
//     auto& row = arm.rows.emplace_back();
//     row.name = "link";
//     row.placement = Origin<double>{{0, 0, 1}, {1.5707963267948966, 0, 0}};
//     row.joint = {.name = "shoulder", .type = JointType::kRevolute};
//     row.joint_stiffness.z() = 1e5;  // N m/rad
//     arm.p_LT = {2, 0, 0};           // m
//     const auto shape = solveFlexibleKinematics(arm, {Eigen::VectorXd::Zero(1), 50});
//     std::printf("%.6f\n", shape.X_BD.p.z() - 1);  // prints -0.002000
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/arm.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

/// Dead loads at the tip, in base axes: magnitude and direction do not change as the arm moves.
template <class S>
struct WrenchOf {
  Vector3<S> force_B = Vector3<S>::Zero();   ///< force at the tip [N]
  Vector3<S> moment_B = Vector3<S>::Zero();  ///< moment at the tip [N m]
};
using Wrench = WrenchOf<double>;

/// Posture of an arm: joint readings [rad, m], one per active row, load hung on the tip [N], and the direction of
/// gravity in the base frame (unit length). The orientation of the base enters only through gravity_B. The members
/// below gravity_B are optional.
template <class S>
struct PostureOf {
  Eigen::Matrix<S, Eigen::Dynamic, 1> q;
  S load{0};
  Vector3<S> gravity_B = -Vector3<S>::UnitZ();
  std::optional<WrenchOf<S>> wrench = {};  ///< loads in addition to the hung load
  /// Readings of the joints of side chains (side_chains.hpp); empty if unknown: see defaultSideReadings().
  Eigen::Matrix<S, Eigen::Dynamic, 1> side_q = {};
  /// Direction of each joint's last motion: -1, 0 or +1. Empty is equivalent to 0 for all joints.
  std::vector<int> approach_directions = {};
  /// Conditions of the posture. The arm's reference value replaces a condition that is not stated. Without a time,
  /// drifts are zero, and slips of the base have already happened.
  ConditionValues conditions = {};
  std::string_view setup = {};  ///< name of the base's set-up; the viewed string must outlive the posture
};
using Posture = PostureOf<double>;

/// Returns true if the arm or the loads that the solver uses may depend on the posture: see dependsOnPosture(arm).
template <class S>
bool dependsOnPosture(const ArmOf<S>& arm, const PostureOf<S>& posture) {
  return dependsOnPosture(arm) || posture.wrench;
}

/// Returns the direction of gravity in the base frame, for a base placed at X_WB.
inline Eigen::Vector3d gravityInBase(const Arm& arm, const Eigen::Isometry3d& X_WB) {
  return X_WB.linear().transpose() * arm.gravity_W;
}

struct FlexibleKinematicsOptions {
  /// Convergence tolerance: largest motion of the tip in a pass, as a fraction of the arm's reach.
  double tolerance = 1e-10;
  int max_iterations = 100;
};

enum class KinematicsStatus {
  kNotRun,
  kConverged,
  kNotConverged,
  kUndefined,  ///< an effect has no finite value at the posture
};

/// Pose of a row's frame, and the loads on it. Forces and moments are resultants of all loads outboard of the row's
/// origin; moments are about that origin.
struct RowState {
  PoseOf<double> X_BL_rigid, X_BL;    ///< frame without and with deflection
  Eigen::Vector3d force_B, moment_B;  ///< force and moment in base axes [N, N m]
  Eigen::Vector3d force_L, moment_L;  ///< force and moment in the row's deflected axes [N, N m]
};

/// Deflection of one element: its row, its law (index into elementKinds()) and its segment index along the member.
struct ComponentState {
  int row = -1;
  int kind = -1;
  int segment = 0;
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();  ///< displacement in the element's near-end axes [m]
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();      ///< rotation of the far end relative to the near end [rad]
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();           ///< part of the rotation within the clearance [rad]
};

struct FlexibleKinematics {
  KinematicsStatus status = KinematicsStatus::kNotRun;
  std::string reason;
  int iterations = 0;
  std::vector<RowState> rows;
  std::vector<ComponentState> components;
  PoseOf<double> X_BT;                                 ///< pose of the undeflected tip, with the last row's axes
  PoseOf<double> X_BD;                                 ///< pose of the deflected tip, with the last row's axes
  Eigen::Matrix3d R_LT = Eigen::Matrix3d::Identity();  ///< tool frame's axes in the last row's frame, effects included
};

/// Solves the deflected shape: computes the loads on the deflected shape, deflects the elements and reassembles the
/// chain, until the tip no longer moves. `posture.q` must have one entry per active row. The arm's effects are
/// included; the result is in the axes of the nominal base, even if effects move the base.
[[nodiscard]] FlexibleKinematics solveFlexibleKinematics(const Arm& arm, const Posture& posture,
                                                         const FlexibleKinematicsOptions& options = {});

/// Returns the deflected poses of all row frames in the world.
std::vector<Eigen::Isometry3d> rowFramesInWorld(const FlexibleKinematics& kinematics, const Eigen::Isometry3d& X_WB);

}  // namespace tubeplan::deflection
