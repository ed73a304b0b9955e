// The complete task: the arm and its base pose, the sheet, the tool and the scene.
#pragma once

#include <vector>

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::planner {

/// A workcell. The world frame W is the sheet frame: origin at the centre of the sheet's lower face, z up, holes along
/// z.
struct Workcell {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< calibrated or nominal pose of the base in the world
  /// Covariance of the base's pose: translation [m], then rotation vector [rad], in world axes. Zero if the pose is
  /// treated as exactly known.
  Eigen::Matrix<double, 6, 6> base_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  /// Standard deviation [m], in any direction, of the position of each row's bodies due to the uncertainty of the arm's
  /// parameters, in addition to `base_covariance`. One typical value over postures for each row. Empty if there is
  /// none.
  std::vector<double> row_deviations = {};
  tubesheets::Sheet sheet;
  tubesheets::SteppedTool tool;
  Scene scene;
  double load = 0;       ///< weight that hangs from the tip [N]
  double insertion = 0;  ///< height of the tip above the lower face at a visit, inside the tube [m]
};

/// Returns the index of the row that carries the tip.
inline int tipRow(const deflection::Arm& arm) { return static_cast<int>(arm.rows.size()) - 1; }

inline const Eigen::Vector3d kHoleAxis_W = Eigen::Vector3d::UnitZ();

/// Returns the centre of a tube's hole on the sheet's lower face [m].
inline Eigen::Vector3d holeCentre(const tubesheets::Tube& tube) { return {tube.x, tube.y, 0}; }

/// Returns the position of the tip at a visit [m]: the cell's insertion above the hole's centre.
inline Eigen::Vector3d visitPlace(const Workcell& cell, const tubesheets::Tube& tube) {
  return holeCentre(tube) + cell.insertion * kHoleAxis_W;
}

}  // namespace tubeplan::planner
