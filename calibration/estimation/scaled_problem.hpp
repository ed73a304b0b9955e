// A least-squares problem in the form that the solvers use: its variables are divided by their scales and kept within
// their bounds, and its evaluations are counted.
#pragma once

#include <string>

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

class ScaledProblem {
 public:
  /// `problem` must outlive this object.
  explicit ScaledProblem(const LeastSquaresProblem& problem);

  // Start and bounds of the scaled variables.
  [[nodiscard]] Eigen::VectorXd start() const { return withinBounds(problem_.start.cwiseQuotient(problem_.scale)); }
  [[nodiscard]] const Eigen::VectorXd& lower() const { return lower_; }
  [[nodiscard]] const Eigen::VectorXd& upper() const { return upper_; }
  [[nodiscard]] Eigen::VectorXd withinBounds(const Eigen::VectorXd& x) const {
    return x.cwiseMax(lower_).cwiseMin(upper_);
  }

  /// Returns r . r at the scaled variables x; infinity if r cannot be evaluated there or is not finite.
  [[nodiscard]] double chi2At(const Eigen::VectorXd& x);

  /// Computes the residuals and their Jacobian with respect to the scaled variables, at the scaled variables x. Returns
  /// false if they cannot be evaluated there or are not finite.
  [[nodiscard]] bool linearizeAt(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& jacobian);

  /// Returns the result of a minimisation that ends at the scaled variables x, with the number of evaluations so far.
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
