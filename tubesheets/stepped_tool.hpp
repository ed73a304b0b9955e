// The stepped calibration tool: how far it enters a hole shows how well it was centred (thesis section 5.5, table 5.7).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "tubesheets/problem.hpp"

namespace tubeplan::tubesheets {

/// One step. [m]
struct Step {
  double diameter = std::numeric_limits<double>::quiet_NaN();
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< largest centring error that still lets it in
};

/// Steps in the order in which they enter, thinnest first; `lengths` [m] one for each step, or none.
struct SteppedTool {
  std::vector<Step> steps;
  std::vector<double> lengths;
};

/// What is wrong with the tool for holes of that diameter [m]: no steps, diameters that do not grow, tolerances that do
/// not shrink or that exceed the gap between step and hole, numbers that are not above zero.
[[nodiscard]] std::vector<Problem> findToolProblems(const SteppedTool& tool, double hole_diameter);

/// What it is that 0, 1, ..., all of its steps enter, for a reader: "no step enters", ..., "all three steps enter".
[[nodiscard]] std::vector<std::string> stepWords(const SteppedTool& tool);

/// How many steps enter at that centring error [m] of a tool that stands upright: those before the first whose
/// tolerance is below it. None for NaN.
[[nodiscard]] int stepsInserted(const SteppedTool& tool, double centring_error);

/// The same of a tool that leans: its tip is `offset` [m] from the hole's axis, and its own axis goes sideways by
/// `lean` for each length that it rises. The tip goes straight up, so that a place `a` below it enters at offset - a *
/// lean; a step enters where both its ends keep its tolerance. A tool without lengths counts as all tip.
[[nodiscard]] int stepsInserted(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean);

/// The most that the tool may lean [rad] for its first step to enter at all, were its tip centred: the step's far end
/// then is at its tolerance. Infinite where the tool states no lengths.
[[nodiscard]] double toleratedTilt(const SteppedTool& tool);

/// The least play that any part of the tool has in a tube that its tip is `depth` [m] deep in, `offset` and `lean` as
/// above [m]: a step's tolerance less how far that part is off the axis. Behind its last length, and where it has none,
/// the tool is as thick as that step, and the first. Negative where it would touch; infinite at no depth (1 um is
/// none).
[[nodiscard]] double playInTube(const SteppedTool& tool, const Eigen::Vector2d& offset, const Eigen::Vector2d& lean,
                                double depth);

/// The probability that exactly 0, 1, ..., n steps enter when the tip's offset from the hole's axis is normal with that
/// mean [m] and covariance [m^2] (singular ones too: a line, a point), the tool leaning as said. Good to 1e-10, to 1e-6
/// for a tool that leans. All NaN when the mean or covariance is not finite or the covariance has a negative variance.
[[nodiscard]] std::vector<double> probabilityBySteps(const SteppedTool& tool, const Eigen::Vector2d& mean_offset,
                                                     const Eigen::Matrix2d& covariance,
                                                     const Eigen::Vector2d& lean = Eigen::Vector2d::Zero());

/// The probability that such an offset is at most `radius` [m] long; NaN as above.
[[nodiscard]] double probabilityWithin(double radius, const Eigen::Vector2d& mean_offset,
                                       const Eigen::Matrix2d& covariance);

}  // namespace tubeplan::tubesheets
