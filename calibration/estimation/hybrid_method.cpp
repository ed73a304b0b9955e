// Hybrid method. Levenberg-Marquardt runs first, because it is fastest for well-posed fits. If it does not converge
// soon, as in a long curved valley, Ipopt runs from the same start. If Ipopt's result has a larger chi-square,
// Levenberg-Marquardt continues from where it stopped.
#include <algorithm>
#include <cmath>

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

namespace {

constexpr int kSoon = 30;  // iterations of Levenberg-Marquardt before Ipopt is tried

/// Returns `found` with the iteration and evaluation counts of `other` added.
LeastSquaresResult withWorkOf(LeastSquaresResult found, const LeastSquaresResult& other) {
  countWork(other, found);
  return found;
}

}  // namespace

LeastSquaresResult minimizeHybrid(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                  const IterationObserver& observe) {
  using Status = LeastSquaresStatus;
  const int soon = std::min(kSoon, stop.max_iterations);
  const LeastSquaresResult quick = minimizeByLevenbergMarquardt(problem, {stop.tolerance, soon}, observe);
  if (quick.status == Status::kConverged || std::isnan(quick.chi2) || stop.max_iterations <= kSoon) return quick;

  const int remaining_iterations = stop.max_iterations - soon;
  const LeastSquaresResult other = minimizeLeastSquares(
      problem,
      {.max_iterations = remaining_iterations, .method = LeastSquaresMethod::kInteriorPoint, .observe = observe});
  if (other.chi2 <= quick.chi2) return withWorkOf(other, quick);

  const LeastSquaresResult first = withWorkOf(quick, other);
  if (quick.status != Status::kIterationLimit) return first;
  LeastSquaresProblem onward = problem;
  onward.start = quick.x;
  return withWorkOf(
      minimizeByLevenbergMarquardt(onward, {stop.tolerance, remaining_iterations - other.iterations}, observe), first);
}

}  // namespace tubeplan::calibration
