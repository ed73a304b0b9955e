// Ceres' Levenberg-Marquardt on the program's own least-squares problems: a yardstick for the methods of `calibration`.
#pragma once

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

/// The same problem, scale, bounds and evaluations as minimizeLeastSquares() sees; one thread, dense QR.
[[nodiscard]] calibration::LeastSquaresResult minimizeByCeres(const calibration::LeastSquaresProblem& problem);

}  // namespace tubeplan::benchmarks
