// Least-squares problems with known solutions, and a wrapper that counts their evaluations.
#pragma once

#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>

#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

inline constexpr double kFar = 1e20;

inline LeastSquaresProblem problemAt(const Eigen::VectorXd& start) {
  LeastSquaresProblem problem;
  problem.start = start;
  problem.lower = Eigen::VectorXd::Constant(start.size(), -kFar);
  problem.upper = Eigen::VectorXd::Constant(start.size(), kFar);
  problem.scale = Eigen::VectorXd::Ones(start.size());
  return problem;
}

inline double chi2Of(const LeastSquaresProblem& problem, const Eigen::VectorXd& x) {
  Eigen::VectorXd r;
  EXPECT_TRUE(problem.evaluate(x, r, nullptr));
  return r.squaredNorm();
}

/// Returns the Rosenbrock problem: a curved valley, whose minimum is zero at (1, 1).
inline LeastSquaresProblem rosenbrock() {
  auto problem = problemAt(Eigen::Vector2d(-1.2, 1));
  problem.evaluate = [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* J) {
    r = Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]);
    if (J) *J = (Eigen::Matrix2d() << -20 * x[0], 10, -1, 0).finished();
    return true;
  };
  return problem;
}

/// Returns the problem log x0 = 0, x1 = x0. It is undefined for x0 <= 0, where a full Newton step from the start would
/// end. The evaluation there fails if `say_so` is true; otherwise it yields NaN.
inline LeastSquaresProblem halfPlane(bool say_so) {
  auto problem = problemAt(Eigen::Vector2d(8, 0));
  problem.evaluate = [say_so](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* J) {
    if (x[0] <= 0 && say_so) return false;
    r = Eigen::Vector2d(x[0] > 0 ? std::log(x[0]) : std::nan(""), x[1] - x[0]);
    if (J) *J = (Eigen::Matrix2d() << 1 / x[0], 0, -1, 1).finished();
    return true;
  };
  return problem;
}

/// Returns a random overdetermined problem A x = b with bounds, which some variables of the unconstrained solution
/// exceed. The columns of A are nearly equal if `own`, the weight of their independent parts, is small.
inline LeastSquaresProblem randomLinear(std::uint64_t seed, double own = 1) {
  constexpr int kRows = 12, kColumns = 5;
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> share(-1, 1);
  Eigen::MatrixXd A(kRows, kColumns);
  Eigen::VectorXd b(kRows);
  for (double& number : A.reshaped()) number = share(random);
  if (own < 1) A = own * A + (1 - own) * A.col(0).replicate<1, kColumns>();
  for (double& number : b) number = 10 * share(random);
  auto problem = problemAt(Eigen::VectorXd::Zero(kColumns));
  problem.lower.setConstant(-1);
  problem.upper.setConstant(1.5);
  problem.evaluate = [A, b](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* J) {
    r = A * x - b;
    if (J) *J = A;
    return true;
  };
  return problem;
}

/// Counts of the evaluations of a problem: without and with a Jacobian, and outside the bounds.
struct EvaluationCounts {
  int values = 0, jacobians = 0, out_of_bounds = 0;
};

inline LeastSquaresProblem watched(LeastSquaresProblem problem, EvaluationCounts& counts) {
  problem.evaluate = [&counts, inner = problem.evaluate, lower = problem.lower, upper = problem.upper](
                         const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* J) {
    ++(J ? counts.jacobians : counts.values);
    counts.out_of_bounds += (x.array() < lower.array()).any() || (x.array() > upper.array()).any();
    return inner(x, r, J);
  };
  return problem;
}

}  // namespace tubeplan::calibration
