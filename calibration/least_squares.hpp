// Nonlinear least squares with bounds: the one question every calibration asks of a solver.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <limits>
#include <string>

namespace tubeplan::calibration {

/// Minimise half the squared length of r(x) within lower <= x <= upper. Residuals are whitened, so that 1 is one sigma.
struct LeastSquaresProblem {
  Eigen::VectorXd start, lower, upper;
  Eigen::VectorXd scale;  ///< typical size of each variable; the solver works in x / scale
  /// Fills r, and the Jacobian (residuals x variables) where it is not null; false: cannot be evaluated here.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian)> evaluate;
};

struct LeastSquaresOptions {
  double tolerance = 1e-10;
  int max_iterations = 200;
};

enum class LeastSquaresStatus { kNotRun, kConverged, kIterationLimit, kFailed };

struct LeastSquaresResult {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd x;
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r at x
  int iterations = 0;
  int evaluations = 0;
  int jacobian_evaluations = 0;
};

/// Solved by Ipopt with exact gradients and the Gauss-Newton Hessian.
[[nodiscard]] LeastSquaresResult minimizeLeastSquares(const LeastSquaresProblem& problem,
                                                      const LeastSquaresOptions& options = {});

}  // namespace tubeplan::calibration
