// Check of the number of segments of beams. Each segment's law assumes small rotations, so that its error grows with
// the square of its length if it bends far. At P L^2 / (E I) = 1 a cantilever of one segment deflects 4 % too far.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

struct Discretisation {
  double tip_error = 0;  ///< estimated error of the deflected tip [m]; NaN if the arm has no equilibrium
  int factor = 1;  ///< factor on the segments of each beam that keeps the error below the allowed; 0: none tried does
};

/// Compares the tip with as many segments as the arm states and with twice as many (Richardson's extrapolation, order
/// two), and finds how many more would leave less than `allowed` [m]. The error is zero if no beam bends.
[[nodiscard]] Discretisation discretisationOf(const Arm& arm, const Posture& posture, double allowed);

/// Returns the largest number of segments of a beam of the arm; 0 if none bends.
[[nodiscard]] int mostSegments(const Arm& arm);

}  // namespace tubeplan::deflection
