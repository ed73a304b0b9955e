// In the hybrid method, the second method must run only if the first does not converge soon, and must never make the
// result worse.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/calibration/estimation/known_problems.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;
using Status = LeastSquaresStatus;

/// Returns a problem with a curved valley that is ten thousand times steeper across than along, and with scales that
/// are far smaller than the valley is long.
LeastSquaresProblem longValley() {
  auto problem = rosenbrock();
  problem.start = Vector2d(-3, 9);
  problem.scale.setConstant(1e-3);
  problem.evaluate = [](const VectorXd& x, VectorXd& r, MatrixXd* J) {
    r = Vector2d(1e4 * (x[1] - x[0] * x[0]), 1 - x[0]);
    if (J) *J = (Eigen::Matrix2d() << -2e4 * x[0], 1e4, -1, 0).finished();
    return true;
  };
  return problem;
}

TEST(HybridMethod, WhatRestsSoonIsLeftToTheFirst) {
  for (const auto& problem : {rosenbrock(), randomLinear(3), halfPlane(true)}) {
    const auto first = minimizeLeastSquares(problem, {.method = LeastSquaresMethod::kLevenbergMarquardt});
    const auto found = minimizeLeastSquares(problem, {.method = LeastSquaresMethod::kHybrid});
    ASSERT_EQ(first.status, Status::kConverged);
    EXPECT_EQ(found.x, first.x);
    EXPECT_EQ(found.reason, first.reason);
    EXPECT_EQ(found.jacobian_evaluations, first.jacobian_evaluations);
    EXPECT_EQ(found.evaluations, first.evaluations);
  }
}

/// However many iterations remain for the second method, the hybrid result must have no larger chi2 than either method
/// alone.
TEST(HybridMethod, EndNoHigherThanEither) {
  constexpr int kFirst = 30;
  const auto problem = longValley();
  const auto at = [&](LeastSquaresMethod method, int limit) {
    return minimizeLeastSquares(problem, {std::nullopt, limit, method});
  };
  const auto first = at(LeastSquaresMethod::kLevenbergMarquardt, kFirst);
  ASSERT_EQ(first.status, Status::kIterationLimit);
  int continued = 0, taken_over = 0;
  for (const int limit : {31, 33, 40, 60, 100, 1000}) {
    const auto other = at(LeastSquaresMethod::kInteriorPoint, limit - kFirst);
    const auto found = at(LeastSquaresMethod::kHybrid, limit);
    EXPECT_LE(found.iterations, limit);
    EXPECT_LE(found.chi2, std::min(first.chi2, other.chi2)) << limit;
    EXPECT_DOUBLE_EQ(found.chi2, chi2Of(problem, found.x));
    ++(other.chi2 > first.chi2 ? continued : taken_over);
  }
  EXPECT_GT(continued, 0);
  EXPECT_GT(taken_over, 0);
}

}  // namespace
}  // namespace tubeplan::calibration
