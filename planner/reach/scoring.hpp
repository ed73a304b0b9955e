// How well the tool is centred under each hole by the true arm, and how far the stepped tool would go in.
#pragma once

#include <vector>

#include "planner/reach/tip_prediction.hpp"

namespace tubeplan::planner {

/// What the true arm does when sent to joint readings q.
struct Centring {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< m, sideways distance from tip to hole axis at the goal
  Eigen::Vector2d offset =
      Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< m, tip minus hole, sheet axes
  double height = std::numeric_limits<double>::quiet_NaN();                 ///< m, tip above the face
  double approach_deviation =
      std::numeric_limits<double>::quiet_NaN();  ///< m, most the tip is off the axis on the way up
  /// Sideways for each length that the tool's axis rises, at the goal.
  Eigen::Vector2d lean = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  int steps = -1;  ///< of the tool that go in, its lean counted over their lengths
};

/// Scores one visit against the truth. `tip_error_W` [m] is what the true arm does beyond its own model, in this
/// posture.
[[nodiscard]] Centring scoreVisit(const Workcell& truth, const Eigen::Vector3d& hole_W, const TubeBranch& visit,
                                  const Eigen::Vector3d& tip_error_W = Eigen::Vector3d::Zero());

/// The same by a truth that is asked often.
[[nodiscard]] Centring scoreVisit(TipPrediction& tips, const Workcell& truth, const Eigen::Vector3d& hole_W,
                                  const TubeBranch& visit,
                                  const Eigen::Vector3d& tip_error_W = Eigen::Vector3d::Zero());

/// How many of the scored visits took 0, 1, ... steps.
[[nodiscard]] std::vector<int> countSteps(const std::vector<Centring>& scores, int steps);

}  // namespace tubeplan::planner
