// Check whether beams are divided into enough segments. The law of a segment assumes small rotations; its error under
// large bending grows with the square of the segment's length. At P L^2 / (E I) = 1, the computed deflection of a
// cantilever of one segment is 4 % too large.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

struct Discretisation {
  double tip_error = 0;  ///< estimated error of the deflected tip [m]; NaN if the arm has no equilibrium
  /// Factor on every beam's number of segments: the smallest of 1, 2, 4, ... 32 that keeps the error allowed; 0 if none
  /// of them does.
  int factor = 1;
};

/// Estimates the error of the tip from its positions with the stated number of segments and with twice as many
/// (Richardson extrapolation of order two). Then doubles the number of segments until the error is at most `allowed`
/// [m]. For an arm without beams, the error is zero.
[[nodiscard]] Discretisation discretisationOf(const Arm& arm, const Posture& posture, double allowed);

/// Returns the largest number of segments of any beam of the arm; 0 if the arm has no beam.
[[nodiscard]] int mostSegments(const Arm& arm);

}  // namespace tubeplan::deflection
