// Tip of the arm without deflection, computed from the joint axes at zero readings (product of exponentials). Start
// postures for the flexible solution are found with this rigid arm. Internal to the inverse kinematics.
#pragma once

#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// The tip at given readings, and its derivatives with respect to the readings, in base axes.
struct TipMotion {
  bool is_converged = true;                                                      ///< false if the other members are NaN
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::UnitZ();  ///< position [m]; tool direction
  Eigen::Vector3d last_axis = Eigen::Vector3d::UnitZ();                          ///< axis of the last joint
  Eigen::Matrix<double, 6, Eigen::Dynamic> columns;  ///< d p [m], then the rotation vector [rad], per unit of a reading
};

/// Joint axes and tip at zero readings, in the base frame.
struct AxesAtZero {
  std::vector<Eigen::Vector3d> point, direction;
  std::vector<bool> slides;
  Eigen::Vector3d tip, tool_axis;
};
[[nodiscard]] AxesAtZero axesAtZero(const Arm& arm);

/// Computes the undeflected tip at readings q [rad, m].
void placeRigidTip(const AxesAtZero& axes, const Eigen::Ref<const Eigen::VectorXd>& q, TipMotion& tip);

}  // namespace tubeplan::deflection
