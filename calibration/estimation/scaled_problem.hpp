// A least-squares problem as presented to the solvers: variables are in units of their scale and always within bounds,
// and every evaluation is counted.
#pragma once

#include <string>

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

class ScaledProblem {
 public:
  /// `problem` must outlive this object.
  explicit ScaledProblem(const LeastSquaresProblem& problem);

  // Start and bounds, in units of the variables' scale.
  [[nodiscard]] Eigen::VectorXd start() const { return withinBounds(problem_.start.cwiseQuotient(problem_.scale)); }
  [[nodiscard]] const Eigen::VectorXd& lower() const { return lower_; }
  [[nodiscard]] const Eigen::VectorXd& upper() const { return upper_; }
  [[nodiscard]] Eigen::VectorXd withinBounds(const Eigen::VectorXd& x) const {
    return x.cwiseMax(lower_).cwiseMin(upper_);
  }

  /// Returns r . r at scaled x; infinity if the problem cannot be evaluated or the value is not finite.
  [[nodiscard]] double chi2At(const Eigen::VectorXd& x);

  /// Computes the residuals at scaled x and their Jacobian with respect to the scaled variables. Returns false if the
  /// problem cannot be evaluated or a value is not finite.
  [[nodiscard]] bool linearizeAt(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& jacobian);

  /// Returns the result of a solver at scaled x, with the evaluations counted so far.
  [[nodiscard]] LeastSquaresResult resultAt(const Eigen::VectorXd& x, double chi2, LeastSquaresStatus status,
                                            std::string reason, int iterations = 0) const;
  [[nodiscard]] LeastSquaresResult failureAtStart() const;

 private:
  [[nodiscard]] Eigen::VectorXd unscaled(const Eigen::VectorXd& x) const;

  const LeastSquaresProblem& problem_;
  Eigen::VectorXd lower_, upper_;
  int evaluations_ = 0, jacobian_evaluations_ = 0;
};

}  // namespace tubeplan::calibration
