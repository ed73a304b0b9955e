// Checks that beams are divided into enough segments. The law of a segment assumes small rotations; its error grows
// with the square of the segment's length. For example, a one-segment cantilever with P L^2 / (E I) = 1 deflects 4 %
// too far.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

struct Discretisation {
  double tip_error = 0;  ///< estimated error of the deflected tip [m]; NaN if the arm has no equilibrium
  /// Factor on every beam's number of segments: the smallest of 1, 2, 4, ... 32 for which the error is acceptable; 0 if
  /// there is none.
  int factor = 1;
};

/// Estimates the discretisation error of the tip position by comparing it with twice as many segments (Richardson
/// extrapolation of order two). Then doubles the number of segments until the error is at most `allowed` [m]. For an
/// arm without beams, the error is zero.
[[nodiscard]] Discretisation discretisationOf(const Arm& arm, const Posture& posture, double allowed);

/// Returns the largest number of segments of any beam of the arm; 0 if the arm has no beam.
[[nodiscard]] int mostSegments(const Arm& arm);

}  // namespace tubeplan::deflection
