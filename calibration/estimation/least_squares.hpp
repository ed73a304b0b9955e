// Interface to the solvers of bounded nonlinear least-squares problems, and the table of the solvers.
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

/// Minimisation of half the squared length of r(x) within lower <= x <= upper. Residuals are whitened: each is in units
/// of its standard deviation. A variable with lower == upper is fixed. A start outside the bounds is moved to the
/// nearest point within them.
struct LeastSquaresProblem {
  Eigen::VectorXd start, lower, upper;
  Eigen::VectorXd scale;  ///< typical size of each variable, above zero; solvers use x / scale internally
  /// Computes r, and the Jacobian (residuals x variables) if `jacobian` is not null. Returns false if r cannot be
  /// evaluated at x. Called only within the bounds.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian)> evaluate;
};

enum class LeastSquaresMethod { kHybrid, kInteriorPoint, kLevenbergMarquardt };

/// Stopping rule of a method. The meaning of the tolerance depends on the method; see the table in least_squares.cpp.
struct LeastSquaresStop {
  double tolerance;
  int max_iterations;
};

/// An iteration of a method, as reported to an observer.
struct LeastSquaresIteration {
  std::string_view method;                                 ///< name of the active method, as in leastSquaresMethods()
  int iteration = 0;                                       ///< iteration number; 0 means the start
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r at the iteration's point
  double step = 0;  ///< length of the step to this point, with each variable in units of its scale
  /// Damping added to the diagonal of the normal matrix for the step; 0 for methods without damping.
  double damping = 0;
};

using IterationObserver = std::function<void(const LeastSquaresIteration&)>;

/// Options for a minimisation. If the tolerance or the iteration limit is empty, the method's default is used.
struct LeastSquaresOptions {
  std::optional<double> tolerance = std::nullopt;
  std::optional<int> max_iterations = std::nullopt;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
  StopQuestion stop = {};          ///< called before every evaluation
  IterationObserver observe = {};  ///< called at every iteration, including iteration 0
};

enum class LeastSquaresStatus { kNotRun, kConverged, kIterationLimit, kFailed, kStopped };

/// Result of a minimisation. `x` is the point where the method stopped, for every status. `chi2` is NaN if r(x) could
/// not be evaluated at any point.
struct LeastSquaresResult {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;  ///< reason why the method stopped
  Eigen::VectorXd x;
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r at x
  int iterations = 0;
  int evaluations = 0;           ///< calls of `evaluate` for r alone
  int jacobian_evaluations = 0;  ///< calls of `evaluate` for r and the Jacobian together
};

/// Adds the iteration and evaluation counts of the result `of` to the counts of `to`.
template <class Counted>
void countWork(const LeastSquaresResult& of, Counted& to) {
  to.iterations += of.iterations;
  to.evaluations += of.evaluations;
  to.jacobian_evaluations += of.jacobian_evaluations;
}

/// A minimisation method: one row of the table.
struct LeastSquaresMethodKind {
  LeastSquaresMethod method;
  std::string_view name;  ///< name on the command line
  LeastSquaresStop stop;  ///< default stopping rule
  LeastSquaresResult (*minimize)(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                 const IterationObserver& observe);
};

/// Returns the table of methods. To add a method, write one file and add one row to this table.
[[nodiscard]] std::span<const LeastSquaresMethodKind> leastSquaresMethods();

/// Solves the problem with the chosen method. Fails (kFailed) if a lower bound exceeds its upper bound. If every
/// variable is fixed, only chi2 is computed.
[[nodiscard]] LeastSquaresResult minimizeLeastSquares(const LeastSquaresProblem& problem,
                                                      const LeastSquaresOptions& options = {});

// Minimisers, one per method, each defined in the file named after its method (for the interior point method,
// ipopt_adapter.cpp).
LeastSquaresResult minimizeHybrid(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                  const IterationObserver& observe);
LeastSquaresResult minimizeByInteriorPoint(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                           const IterationObserver& observe);
LeastSquaresResult minimizeByLevenbergMarquardt(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                                const IterationObserver& observe);

}  // namespace tubeplan::calibration
