// A weighted fit of chosen unknowns to chosen readings, with priors on the unknowns. Identification, cross-validation
// and profile intervals repeat this step.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// The most probable state of the unknowns, given readings and priors.
///
/// If chi-square rejects the stated noise (p < 0.01), the model itself is in error. The variance of this model error is
/// added to every coordinate, so that chi-square equals its degrees of freedom. Readings and priors are then weighted
/// against each other with the increased variance: a drawing that is right to millimetres must not yield to readings
/// with micrometres of stated noise and residuals of tenths of a millimetre.
struct Fit {
  /// Solution of the least-squares problem; its chi2 is that of the weighted readings, without priors.
  LeastSquaresResult solution;
  ReadingWeights weights;      ///< weights of the last iteration
  WhitenedResidual residual;   ///< residual at the solution with these weights, with its Jacobian
  Eigen::MatrixXd covariance;  ///< posterior covariance of the variables
  Eigen::VectorXd factors;     ///< weight factors of the robust loss, included in `weights`; empty without a loss
  double chi2 = kNotKnown;     ///< chi-square of the readings, from their stated noise alone
  /// Number of rows less the number of parameters and unknown places that they determine; may be zero or negative.
  int degrees_of_freedom = 0;
  double p_value = kNotKnown;
};

inline constexpr double kLackOfFit = 0.01;  ///< p-value of chi-square below which a fit rejects the stated noise

struct FitOptions {
  LeastSquaresOptions solver;
  RobustLoss loss = RobustLoss::kNone;
  std::optional<double> model_error = {};  ///< standard deviation of the model error [m]; empty: estimated
  /// Initial weights from the stated noise alone, if already computed; may be null.
  const ReadingWeights* weights = nullptr;
};

/// Calls minimizeLeastSquares(); throws WorkStopped if stopped.
[[nodiscard]] LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem,
                                                  const LeastSquaresOptions& solver);

/// Fits the unknowns, starting at `x`. Weights are computed again at the solution, and the fit is repeated until the
/// weights converge (a few times). Throws WorkStopped if stopped.
[[nodiscard]] Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                              const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                              const FitOptions& options);

/// Returns the least-squares problem of a fit, whose residuals include the priors. The problem keeps references to the
/// arguments.
[[nodiscard]] LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                             const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                             const Eigen::VectorXd& x, const StopQuestion& stop = {});

/// Determines every unknown base pose by closed-form alignment of the predicted tips with the measured positions. The
/// alignment is repeated, because the direction of gravity depends on the base pose. A base with fewer than three
/// positions, or with all positions on one line, is not moved.
void alignBases(PlacedArm& placed, const std::vector<Measurement>& readings);

[[nodiscard]] ErrorSize errorSize(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error);

/// Returns the model error: the standard deviation of each coordinate [m] that, added to the readings' noise, makes
/// chi-square of the errors equal to `degrees_of_freedom`; 0 if the noise alone suffices (p >= 0.01). Gross errors of
/// single readings are left out. `error` is as in WhitenedResidual.
[[nodiscard]] double modelErrorOf(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error, int degrees_of_freedom);

}  // namespace tubeplan::calibration
