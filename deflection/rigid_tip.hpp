// The tip of the arm without deflection, from the axes of its joints at zero readings (a product of exponentials).
// Starts of the flexible solution are searched on it. Internal to the inverse.
#pragma once

#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// A tip at some readings and its motion with them, base axes.
struct TipMotion {
  bool is_converged = true;                                                      ///< false: the other members are NaN
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::UnitZ();  ///< place [m]; direction of the tool
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

/// Computes the rigid tip at readings q [rad, m].
void placeRigidTip(const AxesAtZero& axes, const Eigen::Ref<const Eigen::VectorXd>& q, TipMotion& tip);

}  // namespace tubeplan::deflection
