// Centring of the true arm's tool under each hole, and the number of steps of the stepped tool that enter the hole.
#pragma once

#include <vector>

#include "planner/reach/tip_prediction.hpp"

namespace tubeplan::planner {

/// Result of sending the true arm to commanded joint readings.
struct Centring {
  /// Lateral distance from the tip to the hole's axis at the goal [m].
  double error = std::numeric_limits<double>::quiet_NaN();
  /// Tip position minus hole centre, along the axes of the sheet [m].
  Eigen::Vector2d offset = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  double height = std::numeric_limits<double>::quiet_NaN();  ///< height of the tip above the face [m]
  /// Largest distance of the tip from the hole's axis during the approach [m].
  double approach_deviation = std::numeric_limits<double>::quiet_NaN();
  /// Tilt of the tool at the goal: lateral shift per unit length along the hole's axis.
  Eigen::Vector2d lean = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Number of the tool's steps that enter the hole, allowing for the tilt over the steps' lengths; -1 if not computed.
  int steps = -1;
};

/// Returns the centring of the true arm's tool in one visit. `tip_error_W` [m] is the error of the true tip in this
/// posture that `truth`, the model of the true arm, does not include.
[[nodiscard]] Centring scoreVisit(const Workcell& truth, const Eigen::Vector3d& hole_W, const TubeBranch& visit,
                                  const Eigen::Vector3d& tip_error_W = Eigen::Vector3d::Zero());

/// Overload that reuses `tips`, which must have been created from `truth`.
[[nodiscard]] Centring scoreVisit(TipPrediction& tips, const Workcell& truth, const Eigen::Vector3d& hole_W,
                                  const TubeBranch& visit,
                                  const Eigen::Vector3d& tip_error_W = Eigen::Vector3d::Zero());

/// Returns the number of scored visits in which 0, 1, ..., `steps` steps of the tool entered the hole.
[[nodiscard]] std::vector<int> countSteps(const std::vector<Centring>& scores, int steps);

}  // namespace tubeplan::planner
