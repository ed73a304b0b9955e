// Nonlinear least squares with bounds: the interface of all calibrations to solvers, and the table of solvers.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "calibration/hooks.hpp"

namespace tubeplan::calibration {

/// Problem of minimising half the squared length of r(x) within lower <= x <= upper. Residuals are whitened, so that 1
/// is one sigma. A variable with lower == upper is fixed; a start outside the bounds is moved to the nearest point
/// within them.
struct LeastSquaresProblem {
  Eigen::VectorXd start, lower, upper;
  Eigen::VectorXd scale;  ///< typical size of each variable, above zero; the solver works in x / scale
  /// Computes r, and the Jacobian (residuals x variables) if not null; false: cannot be evaluated at x. It is called
  /// within the bounds only.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian)> evaluate;
};

enum class LeastSquaresMethod { kHybrid, kInteriorPoint, kLevenbergMarquardt };

/// Stopping rule of a method. The quantity compared with the tolerance depends on the method: see
/// leastSquaresMethods().
struct LeastSquaresStop {
  double tolerance;
  int max_iterations;
};

/// An iteration of a method, as reported to an observer.
struct LeastSquaresIteration {
  std::string_view method;                                 ///< name in leastSquaresMethods() of the active method
  int iteration = 0;                                       ///< 0: the start
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r there
  double step = 0;     ///< length of the step that led there, with each variable in units of its scale
  double damping = 0;  ///< value added to the curvature's diagonal for that step; 0 for methods without damping
};

using IterationObserver = std::function<void(const LeastSquaresIteration&)>;

/// Options of a solver. Tolerance and iteration limit are the method's own if they are not stated.
struct LeastSquaresOptions {
  std::optional<double> tolerance = std::nullopt;
  std::optional<int> max_iterations = std::nullopt;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
  StopQuestion stop = {};          ///< called before every evaluation
  IterationObserver observe = {};  ///< called at every iteration, including the start; does not change the result
};

enum class LeastSquaresStatus { kNotRun, kConverged, kIterationLimit, kFailed, kStopped };

/// Result of a solver. `x` is where the method stopped, whatever the status; chi2 stays NaN if the model could not be
/// evaluated at all.
struct LeastSquaresResult {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;  ///< reason why the method stopped
  Eigen::VectorXd x;
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r at x
  int iterations = 0;
  int evaluations = 0;           ///< calls of `evaluate` for r alone
  int jacobian_evaluations = 0;  ///< calls of `evaluate` for r and the Jacobian together
};

/// Counts the work of one search to that of others.
template <class Counted>
void countWork(const LeastSquaresResult& of, Counted& to) {
  to.iterations += of.iterations;
  to.evaluations += of.evaluations;
  to.jacobian_evaluations += of.jacobian_evaluations;
}

/// A way of minimising: one row of the table.
struct LeastSquaresMethodKind {
  LeastSquaresMethod method;
  std::string_view name;  ///< name on the command line
  LeastSquaresStop stop;  ///< default if the caller states none
  LeastSquaresResult (*minimize)(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                 const IterationObserver& observe);
};

/// Returns the open table of methods: a new one is its file and its row.
[[nodiscard]] std::span<const LeastSquaresMethodKind> leastSquaresMethods();

/// Solves by the chosen method. Reversed bounds are refused (kFailed); if every variable is fixed, only chi2 is
/// computed.
[[nodiscard]] LeastSquaresResult minimizeLeastSquares(const LeastSquaresProblem& problem,
                                                      const LeastSquaresOptions& options = {});

// Minimise by one method each, defined in the files of these names; the interior point in ipopt_adapter.cpp.
LeastSquaresResult minimizeHybrid(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                  const IterationObserver& observe);
LeastSquaresResult minimizeByInteriorPoint(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                           const IterationObserver& observe);
LeastSquaresResult minimizeByLevenbergMarquardt(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                                const IterationObserver& observe);

}  // namespace tubeplan::calibration
