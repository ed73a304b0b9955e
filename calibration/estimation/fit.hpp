// Weighted least-squares fit of unknowns to measurements, with priors on the unknowns: the common step of
// identification, cross-validation and profile intervals.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// The most probable values of the unknowns, given measurements and priors.
///
/// If the residuals exceed the stated noise significantly (chi-square, p < 0.01), the model itself is in error. A model
/// error is then added to the variance of every coordinate, as large as needed for chi-square to equal its degrees of
/// freedom. This limits the weight of the measurements relative to the priors. Otherwise, measurements with a stated
/// noise of micrometres but residuals of tenths of a millimetre would override a drawing that is accurate to
/// millimetres.
struct Fit {
  /// Solution of the least-squares problem. Its `chi2` covers the measurements with their final weights, but not the
  /// priors.
  LeastSquaresResult solution;
  MeasurementWeights weights;  ///< weights of the last iteration
  WhitenedResidual residual;   ///< residual at the solution with these weights, with its Jacobian
  Eigen::MatrixXd covariance;  ///< posterior covariance of the variables
  Eigen::VectorXd factors;  ///< weight factors of the robust loss, already included in `weights`; empty without a loss
  double chi2 = kNotKnown;  ///< chi-square of the measurements, from their stated noise alone
  /// Number of rows less the number of parameters and unknown places that they determine; may be zero or negative.
  int degrees_of_freedom = 0;
  double p_value = kNotKnown;
};

inline constexpr double kLackOfFit = 0.01;  ///< p-value below which residuals are too large for the stated noise

struct FitOptions {
  LeastSquaresOptions solver;
  RobustLoss loss = RobustLoss::kNone;
  std::optional<double> model_error = {};  ///< standard deviation of the model error [m]; empty means estimated
  /// Weights from the stated noise alone, if the caller has already computed them; otherwise null.
  const MeasurementWeights* weights = nullptr;
};

/// Returns the result of minimizeLeastSquares(), but throws WorkStopped if the work was stopped.
[[nodiscard]] LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem,
                                                  const LeastSquaresOptions& solver);

/// Fits the unknowns, starting at `x`. The weights depend on the solution, so the fit is repeated with updated weights
/// until they converge (a few times). Throws WorkStopped if a stop is requested.
[[nodiscard]] Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                              const std::vector<Measurement>& measurements, const Eigen::VectorXd& x,
                              const FitOptions& options);

/// Returns the least-squares problem of a fit; its residuals include those of the priors. The problem keeps references
/// to `start`, `unknowns`, `measurements` and `weights`, which must outlive it.
[[nodiscard]] LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                             const std::vector<Measurement>& measurements,
                                             const MeasurementWeights& weights, const Eigen::VectorXd& x,
                                             const StopQuestion& stop = {});

/// Estimates every unknown base pose by aligning the predicted tips with the measured positions in closed form. The
/// alignment is repeated, because the predicted deflection depends on the base pose. A base with fewer than three
/// positions, or with all positions on one line, keeps its pose.
void alignBases(PlacedArm& placed, const std::vector<Measurement>& measurements);

[[nodiscard]] ErrorSize errorSize(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                  const Eigen::VectorXd& error);

/// Returns the model error: the standard deviation of each coordinate [m] that, added to the measurements' noise, makes
/// chi-square of the errors equal to `degrees_of_freedom`; 0 if the noise alone suffices (p >= 0.01). Measurements with
/// gross errors are excluded. `error` is as in WhitenedResidual.
[[nodiscard]] double modelErrorOf(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                  const Eigen::VectorXd& error, int degrees_of_freedom);

}  // namespace tubeplan::calibration
