// Pattern search (Hooke and Jeeves 1961; Calkins 1994, section 5.3.3), which uses values only, no derivatives.
// Exploratory moves change each variable by one step up or down. While chi2 falls, pattern moves repeat the last
// successful displacement and explore around the new point, so that the stride grows. If no move lowers chi2, the step
// is reduced.
#include <algorithm>
#include <cmath>

#include "calibration/estimation/scaled_problem.hpp"
#include "studies/benchmarks/thesis_methods.hpp"

namespace tubeplan::benchmarks {

namespace {

using calibration::LeastSquaresProblem, calibration::LeastSquaresResult, calibration::LeastSquaresStatus;
using calibration::ScaledProblem;

constexpr double kFirstStep = 0.25;  // first step in units of each variable's scale
constexpr double kShrink = 0.5;
constexpr double kLeastStep = 1e-6;
constexpr int kMostIterations = 10000;

struct TriedPlace {
  Eigen::VectorXd x;
  double chi2;
};

TriedPlace explore(ScaledProblem& problem, TriedPlace place, double step) {
  for (Eigen::Index k = 0; k < place.x.size(); ++k)
    for (const double move : {step, -step}) {
      TriedPlace trial = place;
      trial.x[k] = std::clamp(place.x[k] + move, problem.lower()[k], problem.upper()[k]);
      if (trial.x[k] == place.x[k]) continue;
      trial.chi2 = problem.chi2At(trial.x);
      if (!(trial.chi2 < place.chi2)) continue;
      place = trial;
      break;
    }
  return place;
}

/// Makes pattern moves in the direction from `base` to `found` until a move does not lower chi2, and returns the best
/// point.
TriedPlace followPattern(ScaledProblem& problem, TriedPlace base, TriedPlace found, double step, int& iterations) {
  while (found.chi2 < base.chi2 && iterations < kMostIterations) {
    ++iterations;
    TriedPlace ahead{problem.withinBounds(2 * found.x - base.x), 0};
    ahead.chi2 = problem.chi2At(ahead.x);
    base = found;
    found = explore(problem, ahead, step);
  }
  return found.chi2 < base.chi2 ? found : base;
}

}  // namespace

LeastSquaresResult minimizeByHookeJeeves(const LeastSquaresProblem& problem) {
  ScaledProblem scaled(problem);
  TriedPlace base{scaled.start(), 0};
  base.chi2 = scaled.chi2At(base.x);
  if (!std::isfinite(base.chi2)) return scaled.failureAtStart();
  double step = kFirstStep;
  int iterations = 0;
  while (step > kLeastStep && iterations < kMostIterations) {
    ++iterations;
    const TriedPlace found = explore(scaled, base, step);
    if (found.chi2 < base.chi2)
      base = followPattern(scaled, base, found, step, iterations);
    else
      step *= kShrink;
  }
  const bool done = step <= kLeastStep;
  return scaled.resultAt(base.x, base.chi2, done ? LeastSquaresStatus::kConverged : LeastSquaresStatus::kIterationLimit,
                         done ? "the step is within tolerance" : "stopped at the iteration limit", iterations);
}

}  // namespace tubeplan::benchmarks
