// Centring of the tool under each hole by the true arm, and the number of steps of the stepped tool that enter.
#pragma once

#include <vector>

#include "planner/reach/tip_prediction.hpp"

namespace tubeplan::planner {

/// Response of the true arm when sent to joint readings q.
struct Centring {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< lateral distance from tip to hole axis at the goal [m]
  /// Tip minus hole, sheet axes [m].
  Eigen::Vector2d offset = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  double height = std::numeric_limits<double>::quiet_NaN();  ///< height of the tip above the face [m]
  /// Largest distance of the tip from the axis during the approach [m].
  double approach_deviation = std::numeric_limits<double>::quiet_NaN();
  /// Lateral shift per length along the tool's axis, at the goal.
  Eigen::Vector2d lean = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  int steps = -1;  ///< number of the tool's steps that enter, its lean over their lengths included
};

/// Scores one visit against the truth. `tip_error_W` [m] is the error of the true arm beyond its own model, in this
/// posture.
[[nodiscard]] Centring scoreVisit(const Workcell& truth, const Eigen::Vector3d& hole_W, const TubeBranch& visit,
                                  const Eigen::Vector3d& tip_error_W = Eigen::Vector3d::Zero());

/// Scores one visit with a prepared model of the truth.
[[nodiscard]] Centring scoreVisit(TipPrediction& tips, const Workcell& truth, const Eigen::Vector3d& hole_W,
                                  const TubeBranch& visit,
                                  const Eigen::Vector3d& tip_error_W = Eigen::Vector3d::Zero());

/// Returns how many of the scored visits took 0, 1, ... steps.
[[nodiscard]] std::vector<int> countSteps(const std::vector<Centring>& scores, int steps);

}  // namespace tubeplan::planner
