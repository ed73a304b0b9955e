// Levenberg-Marquardt method of Ceres on the program's own least-squares problems, as a reference for the methods of
// `calibration`.
#pragma once

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

/// Minimises the same problem with the scale, bounds and evaluations of minimizeLeastSquares(), by one thread with
/// dense QR.
[[nodiscard]] calibration::LeastSquaresResult minimizeByCeres(const calibration::LeastSquaresProblem& problem);

}  // namespace tubeplan::benchmarks
