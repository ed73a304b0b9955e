// The stepped calibration tool: the number of steps that enter a hole shows how well the tool was centred (thesis
// section 5.5, table 5.7).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "tubesheets/problem.hpp"

namespace tubeplan::tubesheets {

/// One step of the tool [m].
struct Step {
  double diameter = std::numeric_limits<double>::quiet_NaN();
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< largest centring error at which it enters
};

/// Steps in the order in which they enter, thinnest first. `lengths` [m] has one number for each step, or none.
struct SteppedTool {
  std::vector<Step> steps;
  std::vector<double> lengths;
};

/// Returns what is wrong with the tool for holes of that diameter [m]: no steps, diameters that do not grow, tolerances
/// that do not shrink or that exceed the gap between step and hole, numbers that are not above zero.
[[nodiscard]] std::vector<Problem> findToolProblems(const SteppedTool& tool, double hole_diameter);

/// Returns a phrase for each count of entered steps from 0 up: "no step enters", ..., "all three steps enter".
[[nodiscard]] std::vector<std::string> stepWords(const SteppedTool& tool);

/// Returns how many steps of an upright tool enter at that centring error [m]: those before the first whose tolerance
/// is below it. 0 for NaN.
[[nodiscard]] int stepsInserted(const SteppedTool& tool, double centring_error);

/// Returns how many steps of a leaning tool enter. Its tip is `offset` [m] from the hole's axis, and its axis moves
/// sideways by `lean` per unit length upwards. The tip rises vertically, so that a section `a` below it enters at
/// offset - a * lean. A step enters if both its ends keep its tolerance. A tool without lengths has all steps at its
/// tip.
[[nodiscard]] int stepsInserted(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean);

/// Returns the largest tilt [rad] at which the first step still enters with a centred tip: the step's far end is then
/// at its tolerance. Infinite if the tool states no lengths.
[[nodiscard]] double toleratedTilt(const SteppedTool& tool);

/// Returns the least clearance [m] of any part of the tool in a tube that its tip has entered by `depth` [m], with
/// `offset` and `lean` as above: a step's tolerance less that part's distance from the axis. Behind its last length the
/// tool is as thick as its last step; without lengths, as its first. Negative if it would touch; infinite at no depth
/// (below 1 um).
[[nodiscard]] double playInTube(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean,
                                double depth);

/// Returns the probabilities that exactly 0, 1, ..., n steps enter. The tip's offset from the hole's axis is normal
/// with that mean [m] and covariance [m^2] (singular ones too: a line, a point), and the tool has that lean. Accurate
/// to 1e-10, to 1e-6 for a tool that leans. All NaN if the mean or covariance is not finite or the covariance has a
/// negative variance.
[[nodiscard]] std::vector<double> probabilityBySteps(const SteppedTool& tool, const Eigen::Vector2d& mean_offset,
                                                     const Eigen::Matrix2d& covariance,
                                                     const Eigen::Vector2d& lean = Eigen::Vector2d::Zero());

/// Returns the probability that such an offset is at most `radius` [m] long; NaN in the same cases.
[[nodiscard]] double probabilityWithin(double radius, const Eigen::Vector2d& mean_offset,
                                       const Eigen::Matrix2d& covariance);

}  // namespace tubeplan::tubesheets
