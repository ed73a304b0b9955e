// The stepped calibration tool: the number of steps that enter a hole measures how well the tool is centred (Calkins
// 1994, section 5.5, table 5.7).
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
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< largest centring error at which the step enters
};

/// Steps in the order in which they enter a hole, thinnest first. `lengths` has the length of each step [m], or is
/// empty.
struct SteppedTool {
  std::vector<Step> steps;
  std::vector<double> lengths;
};

/// Returns the problems of a tool for holes of that diameter [m]: no steps, diameters that do not increase, tolerances
/// that do not decrease or that exceed the gap between step and hole, values that are not above zero.
[[nodiscard]] std::vector<Problem> findToolProblems(const SteppedTool& tool, double hole_diameter);

/// Cross-section of the tool that must be within `tolerance` [m] of the hole's axis for its step to enter.
struct Section {
  std::size_t step = 0;
  double below = 0;  ///< distance below the tip [m]
  double tolerance = 0;
};

/// Returns both ends of every step from the tip down, or one section at the tip for each if the tool has no lengths.
[[nodiscard]] std::vector<Section> sectionsOf(const SteppedTool& tool);

/// Returns the depth below the tip of the middle of a step [m]; 0 for a tool without lengths.
[[nodiscard]] double middleOf(const SteppedTool& tool, std::size_t step);

/// Returns a phrase for each number of entered steps from 0 up: "no step enters", ..., "all three steps enter".
[[nodiscard]] std::vector<std::string> stepWords(const SteppedTool& tool);

/// Returns the number of steps of an upright tool that enter a hole if the tool's axis is `centring_error` [m] from the
/// hole's axis: the steps before the first one whose tolerance is less than the error. Returns 0 for NaN.
[[nodiscard]] int stepsInserted(const SteppedTool& tool, double centring_error);

/// Returns the number of steps of a tilted tool that enter a hole. The tip is `offset` [m] from the hole's axis, and
/// the tool's axis moves sideways by `lean` per unit length upwards. The tip rises vertically, so that a section at `a`
/// [m] below the tip enters at offset - a * lean. A step enters if both of its ends are within its tolerance. If the
/// tool has no lengths, all steps are at the tip.
[[nodiscard]] int stepsInserted(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean);

/// Returns the largest tilt [rad] at which the first step still enters when the tip is centred: at that tilt, the far
/// end of the step just touches the tube. Infinite if the lengths of the steps are not given.
[[nodiscard]] double toleratedTilt(const SteppedTool& tool);

/// Returns the smallest clearance [m] of any part of the tool in a tube that its tip has entered by `depth` [m], with
/// `offset` and `lean` as for stepsInserted(). The clearance of a part is the tolerance of its step minus the distance
/// of the part from the hole's axis. Beyond its last step the tool is as thick as that step; without lengths, all of it
/// is as thick as the first step. Negative if the tool would touch the tube; infinite at zero depth (below 1 um).
[[nodiscard]] double playInTube(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean,
                                double depth);

/// Returns the probabilities that exactly 0, 1, ..., n of the n steps enter. The offset of the tip from the hole's axis
/// is normal with that mean [m] and covariance [m^2], which may be singular (a line or a point), and the tool has the
/// tilt `lean`. Accurate to 1e-10, or to 1e-6 for a tilted tool. All probabilities are NaN if the mean or covariance is
/// not finite or the covariance has a negative variance.
[[nodiscard]] std::vector<double> probabilityBySteps(const SteppedTool& tool, const Eigen::Vector2d& mean_offset,
                                                     const Eigen::Matrix2d& covariance,
                                                     const Eigen::Vector2d& lean = Eigen::Vector2d::Zero());

/// Returns the probability that a normally distributed offset with that mean and covariance is at most `radius` [m]
/// long; NaN as for probabilityBySteps().
[[nodiscard]] double probabilityWithin(double radius, const Eigen::Vector2d& mean_offset,
                                       const Eigen::Matrix2d& covariance);

}  // namespace tubeplan::tubesheets
