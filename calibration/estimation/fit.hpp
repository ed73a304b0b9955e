// A weighted fit of chosen unknowns to chosen readings, with their priors: the step that identification, held-out
// judgement and profiles repeat.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// The most probable state of the unknowns, given readings and priors.
///
/// If chi-square rejects the stated noise (p < 0.01), the model has an error of its own. It is added as a further
/// variance of every coordinate, so large that chi-square equals its degrees of freedom. Readings and priors are
/// weighed against each other with it: a drawing right to millimetres must not yield to readings with micrometres of
/// stated noise and residuals of tenths.
struct Fit {
  LeastSquaresResult solution;  ///< its chi2 is that of the weighted readings, without priors
  ReadingWeights weights;       ///< weights used last
  WhitenedResidual residual;    ///< residual at the solution with these weights, with its Jacobian
  Eigen::MatrixXd covariance;   ///< posterior, of the variables
  Eigen::VectorXd factors;      ///< robust weights within `weights`; empty without a loss
  double chi2 = kNotKnown;      ///< of the readings by their stated noise alone
  int degrees_of_freedom = 0;   ///< of the readings, less the numbers that they determine; may be none
  double p_value = kNotKnown;
};

inline constexpr double kLackOfFit = 0.01;  ///< p of chi-square below which a fit rejects the stated noise

struct FitOptions {
  LeastSquaresOptions solver;
  RobustLoss loss = RobustLoss::kNone;
  std::optional<double> model_error = {};   ///< [m]; estimated by the fit if not stated
  const ReadingWeights* weights = nullptr;  ///< start weights by the stated noise alone, if they exist already
};

/// Calls minimizeLeastSquares(); throws WorkStopped if the solver was stopped.
[[nodiscard]] LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem,
                                                  const LeastSquaresOptions& solver);

/// Fits from `x`. The weights are computed again at the solution and the fit is repeated until they converge (a few
/// times). Throws WorkStopped if the solver was stopped.
[[nodiscard]] Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                              const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                              const FitOptions& options);

/// Returns the least-squares problem of a fit, with priors among its residuals. It keeps references to the arguments.
[[nodiscard]] LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                             const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                             const Eigen::VectorXd& x, const StopQuestion& stop = {});

/// Places every unknown base by a closed-form alignment of tips with measured places, repeated because gravity's
/// direction follows. Set-ups with fewer than three separate places are not moved.
void alignBases(PlacedArm& placed, const std::vector<Measurement>& readings);

[[nodiscard]] ErrorSize errorSize(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error);

/// Returns the standard deviation of each coordinate [m] that, added to the readings' noise, makes chi-square of these
/// errors equal to `degrees_of_freedom`; 0 if the noise is enough (p >= 0.01). Gross errors of single readings are left
/// out. `error` as in WhitenedResidual.
[[nodiscard]] double modelErrorOf(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error, int degrees_of_freedom);

}  // namespace tubeplan::calibration
