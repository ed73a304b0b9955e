// The two minimisation methods of the thesis (Calkins 1994, section 5.3.3), for comparison with the program's methods.
#pragma once

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

[[nodiscard]] calibration::LeastSquaresResult minimizeByHookeJeeves(const calibration::LeastSquaresProblem& problem);
[[nodiscard]] calibration::LeastSquaresResult minimizeBySteepestDescent(
    const calibration::LeastSquaresProblem& problem);

}  // namespace tubeplan::benchmarks
