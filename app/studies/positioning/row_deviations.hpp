// Uncertainty of the positions of the arm's bodies due to the arm's parameters, in addition to the uncertainty of the
// base.
#pragma once

#include <vector>

#include "calibration/estimation/touch_fit.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns Workcell::row_deviations for base and arm with the given joint uncertainty: for each row, the standard
/// deviation [m] that the arm adds to the base's, in the worst direction and at the worst point (the ends of the row's
/// bodies, and the tip). It is the root mean square over 256 random postures within the joint limits. Empty if no
/// parameter of the arm is uncertain.
[[nodiscard]] std::vector<double> rowDeviations(const planner::Workcell& model,
                                                const calibration::JointUncertainty& uncertainty);

}  // namespace tubeplan::app
