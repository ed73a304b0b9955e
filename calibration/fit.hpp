// One weighted fit of chosen unknowns to chosen readings: what identification, held-out judgement and profiles repeat.
#pragma once

#include <optional>

#include "calibration/identification.hpp"

namespace tubeplan::calibration {

struct Fit {
  LeastSquaresResult solution;
  ReadingWeights weights;     ///< as used last
  WhitenedResidual residual;  ///< at the solution, with its Jacobian
  Eigen::VectorXd factors;    ///< robust weights within `weights`; empty without a loss
};

/// minimizeLeastSquares; unwinds by WorkStopped where the solver was stopped.
[[nodiscard]] LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem,
                                                  const LeastSquaresOptions& solver);

/// Fits from `x`; the weights are taken anew at the solution and the fit repeated until they rest (at most thrice).
/// Unwinds where the solver was stopped.
[[nodiscard]] Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                              const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                              const LeastSquaresOptions& solver, RobustLoss loss = RobustLoss::kNone);

/// The least-squares problem of a fit, for a solver. Keeps references to its arguments.
[[nodiscard]] LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                             const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                             const Eigen::VectorXd& x);

/// Places every base that is not known by a closed-form alignment of tips on measured places, repeated since gravity's
/// direction follows; set-ups with fewer than three separate places stay where they are.
void alignPlacings(PlacedArm& placed, const std::vector<Measurement>& readings);

[[nodiscard]] ErrorSize errorSize(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error);

/// Covariance of the unknowns by a whitened Jacobian, whatever their units; what it cannot tell has none.
[[nodiscard]] Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& jacobian);

/// Upper tail of chi-square; 1 where there is no freedom.
[[nodiscard]] double chiSquareTail(double chi2, double degrees_of_freedom);

}  // namespace tubeplan::calibration
