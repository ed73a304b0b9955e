// Check of the number of segments of beams. The law of a segment assumes small rotations, so for large bending its
// error grows with the square of the segment's length. At P L^2 / (E I) = 1, the computed deflection of a cantilever of
// one segment is 4 % too large.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

struct Discretisation {
  double tip_error = 0;  ///< estimated error of the deflected tip [m]; NaN if the arm has no equilibrium
  /// Multiplier of each beam's number of segments that keeps the error below the allowed error; 0: none was found.
  int factor = 1;
};

/// Compares the tip for the stated number of segments with the tip for twice as many (Richardson extrapolation of order
/// two). Also finds the number of segments that leaves an error below `allowed` [m]. The error is zero if no beam
/// bends.
[[nodiscard]] Discretisation discretisationOf(const Arm& arm, const Posture& posture, double allowed);

/// Returns the largest number of segments of any beam of the arm; 0 if the arm has no beam.
[[nodiscard]] int mostSegments(const Arm& arm);

}  // namespace tubeplan::deflection
