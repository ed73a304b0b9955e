// The task in one place: which arm stands where, under which sheet, with which tool, among what.
#pragma once

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::planner {

/// World frame W = sheet frame: origin at the centre of the sheet's lower face, z up, holes along z.
struct Workcell {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< base, as calibrated or nominal
  /// Of the base's pose: translation [m], then rotation vector [rad], world axes. Zero where it is taken as known.
  Eigen::Matrix<double, 6, 6> base_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  tubesheets::Sheet sheet;
  tubesheets::SteppedTool tool;
  Scene scene;
  double load = 0;       ///< N, hung on the tip
  double insertion = 0;  ///< m, how far past the face the tip goes into a tube
};

inline const Eigen::Vector3d kHoleAxis_W = Eigen::Vector3d::UnitZ();

/// The hole's centre on the sheet's lower face.
inline Eigen::Vector3d holeCentre(const tubesheets::Tube& tube) { return {tube.x, tube.y, 0}; }

/// Where a visit brings the tip: the hole's centre, or as far above it as the cell's insertion says.
inline Eigen::Vector3d visitPlace(const Workcell& cell, const tubesheets::Tube& tube) {
  return holeCentre(tube) + cell.insertion * kHoleAxis_W;
}

}  // namespace tubeplan::planner
