// Whether beams are cut into enough segments. Each segment's law is that of small rotations; one that bends far under
// its load is off by the square of its length: at P L^2 / (E I) = 1 a cantilever of one segment deflects 4 % too far.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

struct Discretisation {
  double tip_error = 0;  ///< m, estimated of the deflected tip; NaN where the arm does not come to rest
  int factor = 1;        ///< so often as many segments in each beam leave less than was allowed; 0: none tried does
};

/// The tip by as many segments as the arm states beside that by twice as many (Richardson's extrapolation, order two),
/// and how many more would leave less than `allowed` [m]. Nothing to estimate where no beam bends: zero.
[[nodiscard]] Discretisation discretisationOf(const Arm& arm, const Posture& posture, double allowed);

/// The most segments that a beam of the arm states; 0 where none bends.
[[nodiscard]] int mostSegments(const Arm& arm);

}  // namespace tubeplan::deflection
