// The task in one place: the arm and its base, the sheet, the tool and the scene.
#pragma once

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::planner {

/// A workcell. World frame W = sheet frame: origin at the centre of the sheet's lower face, z up, holes along z.
struct Workcell {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< base, as calibrated or nominal
  /// Covariance of the base's pose: translation [m], then rotation vector [rad], world axes. Zero if it is taken as
  /// known.
  Eigen::Matrix<double, 6, 6> base_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  tubesheets::Sheet sheet;
  tubesheets::SteppedTool tool;
  Scene scene;
  double load = 0;       ///< hung on the tip [N]
  double insertion = 0;  ///< depth of the tip in a tube beyond the face [m]
};

inline const Eigen::Vector3d kHoleAxis_W = Eigen::Vector3d::UnitZ();

/// Returns the hole's centre on the sheet's lower face [m].
inline Eigen::Vector3d holeCentre(const tubesheets::Tube& tube) { return {tube.x, tube.y, 0}; }

/// Returns the place of the tip at a visit [m]: the hole's centre, or the cell's insertion above it.
inline Eigen::Vector3d visitPlace(const Workcell& cell, const tubesheets::Tube& tube) {
  return holeCentre(tube) + cell.insertion * kHoleAxis_W;
}

}  // namespace tubeplan::planner
