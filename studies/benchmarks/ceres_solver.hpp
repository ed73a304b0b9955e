// Levenberg-Marquardt method of Ceres for the program's least-squares problems, as a reference for the methods of
// `calibration`.
#pragma once

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

/// Minimises a least-squares problem with Ceres (one thread, dense QR), with the same variable scales, bounds and
/// evaluations as minimizeLeastSquares().
[[nodiscard]] calibration::LeastSquaresResult minimizeByCeres(const calibration::LeastSquaresProblem& problem);

}  // namespace tubeplan::benchmarks
