// The tip of the arm as if nothing gave, by the axes of its joints at zero readings (a product of exponentials): what
// the starts of the flexible solution are searched on. Internal to the inverse.
#pragma once

#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// A tip at some readings and how it moves with them, base axes.
struct TipMotion {
  bool is_converged = true;                                                      ///< false: the rest are not numbers
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::UnitZ();  ///< place [m]; the tool's direction
  Eigen::Vector3d last_axis = Eigen::Vector3d::UnitZ();                          ///< of the last joint
  Eigen::Matrix<double, 6, Eigen::Dynamic> columns;  ///< d p [m], then the rotation vector [rad], per unit of a reading
};

/// Joint axes and tip at zero readings, in the base frame.
struct AxesAtZero {
  std::vector<Eigen::Vector3d> point, direction;
  std::vector<bool> slides;
  Eigen::Vector3d tip, tool_axis;
};
[[nodiscard]] AxesAtZero axesAtZero(const Arm& arm);

/// The rigid tip at readings q [rad, m].
void placeRigidTip(const AxesAtZero& axes, const Eigen::Ref<const Eigen::VectorXd>& q, TipMotion& tip);

}  // namespace tubeplan::deflection
