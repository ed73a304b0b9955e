// The thesis's two ways to minimise (section 5.3.3), which the program's own are measured beside.
#pragma once

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

[[nodiscard]] calibration::LeastSquaresResult minimizeByHookeJeeves(const calibration::LeastSquaresProblem& problem);
[[nodiscard]] calibration::LeastSquaresResult minimizeBySteepestDescent(
    const calibration::LeastSquaresProblem& problem);

}  // namespace tubeplan::benchmarks
