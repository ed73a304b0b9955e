// One weighted fit of chosen unknowns to chosen readings, with their priors: what identification, held-out judgement
// and profiles repeat.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// The most probable state of the unknowns by readings and priors.
///
/// Where chi-square refuses the stated noise (p < 0.01), the model has an error of its own. It is taken as one more
/// variance of every coordinate, as large as makes chi-square what its degrees of freedom expect, and readings and
/// priors are weighed against each other by it: a drawing right to millimetres must not yield to readings that state
/// micrometres of noise and are missed by tenths.
struct Fit {
  LeastSquaresResult solution;  ///< its chi2 is that of the readings as weighted, without priors
  ReadingWeights weights;       ///< as used last
  WhitenedResidual residual;    ///< at the solution by these weights, with its Jacobian
  Eigen::MatrixXd covariance;   ///< posterior, of the variables
  Eigen::VectorXd factors;      ///< robust weights within `weights`; empty without a loss
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< of the readings by their stated noise alone
  int degrees_of_freedom = 0;  ///< of the readings, less the numbers that they determine; may be none
  double p_value = std::numeric_limits<double>::quiet_NaN();
};

inline constexpr double kLackOfFit = 0.01;  ///< p of chi-square below which a fit refuses the stated noise

struct FitOptions {
  LeastSquaresOptions solver;
  RobustLoss loss = RobustLoss::kNone;
  std::optional<double> model_error = {};   ///< m; found by the fit where it is not stated
  const ReadingWeights* weights = nullptr;  ///< at the start by the stated noise alone, where they are made already
};

/// minimizeLeastSquares; unwinds by WorkStopped where the solver was stopped.
[[nodiscard]] LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem,
                                                  const LeastSquaresOptions& solver);

/// Fits from `x`; the weights are taken anew at the solution and the fit repeated until they rest (a few times).
/// Unwinds where the solver was stopped.
[[nodiscard]] Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                              const std::vector<Measurement>& readings, const Eigen::VectorXd& x,
                              const FitOptions& options);

/// The least-squares problem of a fit, for a solver, priors among its residuals. Keeps references to its arguments.
[[nodiscard]] LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                             const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                             const Eigen::VectorXd& x, const StopQuestion& stop = {});

/// Places every base that is not known by a closed-form alignment of tips on measured places, repeated since gravity's
/// direction follows; set-ups with fewer than three separate places stay where they are.
void alignBases(PlacedArm& placed, const std::vector<Measurement>& readings);

[[nodiscard]] ErrorSize errorSize(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error);

/// Standard deviation of each coordinate [m] that, beside the readings' noise, makes chi-square of these errors what
/// `degrees_of_freedom` expect; 0 where the noise is enough (p >= 0.01). Gross errors of single readings are left out.
/// `error` as in WhitenedResidual.
[[nodiscard]] double modelErrorOf(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const Eigen::VectorXd& error, int degrees_of_freedom);

}  // namespace tubeplan::calibration
