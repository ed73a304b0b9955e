// Uncertainty that the arm's parameters add to the positions of its bodies, beyond that of the base.
#pragma once

#include <vector>

#include "calibration/estimation/touch_fit.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns Workcell::row_deviations for base and arm with the given joint uncertainty: for each row, the largest
/// standard deviation [m] beyond that of the base alone, over 256 random postures within the joint limits and over the
/// ends of the row's bodies and the tip. Empty if no parameter of the arm is uncertain.
[[nodiscard]] std::vector<double> rowDeviations(const planner::Workcell& model,
                                                const calibration::JointUncertainty& uncertainty);

}  // namespace tubeplan::app
