// Nonlinear least squares with bounds: the one question every calibration asks of a solver, and the table of solvers.
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

/// Minimise half the squared length of r(x) within lower <= x <= upper. Residuals are whitened, so that 1 is one sigma.
/// A variable with lower == upper is fixed; a start outside the bounds is moved to the nearest point within them.
struct LeastSquaresProblem {
  Eigen::VectorXd start, lower, upper;
  Eigen::VectorXd scale;  ///< typical size of each variable, above zero; the solver works in x / scale
  /// Fills r, and the Jacobian (residuals x variables) where it is not null; false: cannot be evaluated here. Asked
  /// within the bounds only.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian)> evaluate;
};

enum class LeastSquaresMethod { kHybrid, kInteriorPoint, kLevenbergMarquardt };

/// When a method rests. What the tolerance is measured on is the method's own affair: see leastSquaresMethods().
struct LeastSquaresStop {
  double tolerance;
  int max_iterations;
};

/// An iteration of a method, as it is reported to whoever watches.
struct LeastSquaresIteration {
  std::string_view method;  ///< by its name in leastSquaresMethods(), of the one that is at work
  int iteration = 0;        ///< 0: the start
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r there
  double step = 0;     ///< length of the step that led there, each variable in units of its scale
  double damping = 0;  ///< added to the curvature's diagonal for that step; 0 where the method has none
};

using IterationObserver = std::function<void(const LeastSquaresIteration&)>;

/// Tolerance and iteration limit are the method's own where they are not stated.
struct LeastSquaresOptions {
  std::optional<double> tolerance = std::nullopt;
  std::optional<int> max_iterations = std::nullopt;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
  StopQuestion stop = {};          ///< asked before every evaluation
  IterationObserver observe = {};  ///< called at every iteration, the start too; it changes no result
};

enum class LeastSquaresStatus { kNotRun, kConverged, kIterationLimit, kFailed, kStopped };

/// x is where the method stopped, whatever the status; chi2 stays NaN where the model could not be evaluated at all.
struct LeastSquaresResult {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;  ///< why the method stopped
  Eigen::VectorXd x;
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< r . r at x
  int iterations = 0;
  int evaluations = 0;           ///< calls of `evaluate` for r alone
  int jacobian_evaluations = 0;  ///< calls of `evaluate` for r and the Jacobian together
};

/// A way of minimising: one row of the table.
struct LeastSquaresMethodKind {
  LeastSquaresMethod method;
  std::string_view name;  ///< on the command line
  LeastSquaresStop stop;  ///< where the caller states none
  LeastSquaresResult (*minimize)(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                 const IterationObserver& observe);
};

/// The open table: a new method is its file and its row.
[[nodiscard]] std::span<const LeastSquaresMethodKind> leastSquaresMethods();

/// Solved by the method asked for. Bounds the wrong way round are refused (kFailed), and where every variable is fixed
/// only chi2 is found.
[[nodiscard]] LeastSquaresResult minimizeLeastSquares(const LeastSquaresProblem& problem,
                                                      const LeastSquaresOptions& options = {});

// Declared here, each defined in the file of its name; the interior point in ipopt_adapter.cpp.
LeastSquaresResult minimizeHybrid(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                  const IterationObserver& observe);
LeastSquaresResult minimizeByInteriorPoint(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                           const IterationObserver& observe);
LeastSquaresResult minimizeByLevenbergMarquardt(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                                const IterationObserver& observe);

}  // namespace tubeplan::calibration
