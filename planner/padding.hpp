// How far the arm may stand from where its model has it, as far as the base's calibration tells.
#pragma once

#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// `sigmas` times the greatest standard deviation [m], in any direction, that the covariance of the base gives to any
/// point within the arm's reach of it. A point p moves by t + w x (p - p_WB); its standard deviation is a convex
/// function of p, so that none within a box exceeds that of the box's worst corner. The box is the one around the
/// reach, which counts the bodies too.
[[nodiscard]] double paddingOf(const Workcell& cell, double sigmas);

}  // namespace tubeplan::planner
