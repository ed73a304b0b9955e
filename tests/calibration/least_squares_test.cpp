// The solver behind every fit, on problems with known answers.
#include "calibration/least_squares.hpp"

#include <gtest/gtest.h>

namespace tubeplan::calibration {
namespace {

LeastSquaresProblem rosenbrock() {
  LeastSquaresProblem problem;
  problem.start = Eigen::Vector2d(-1.2, 1);
  problem.lower = Eigen::Vector2d::Constant(-1e20);
  problem.upper = Eigen::Vector2d::Constant(1e20);
  problem.scale = Eigen::Vector2d::Ones();
  problem.evaluate = [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* J) {
    r = Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]);
    if (J) *J = (Eigen::Matrix2d() << -20 * x[0], 10, -1, 0).finished();
    return true;
  };
  return problem;
}

TEST(LeastSquares, FindsTheBottomOfTheValley) {
  const auto found = minimizeLeastSquares(rosenbrock());
  ASSERT_EQ(found.status, LeastSquaresStatus::kConverged) << found.reason;
  EXPECT_NEAR(found.x[0], 1, 1e-8);
  EXPECT_NEAR(found.x[1], 1, 1e-8);
  EXPECT_NEAR(found.chi2, 0, 1e-14);
}

TEST(LeastSquares, StaysWithinBounds) {
  auto problem = rosenbrock();
  problem.upper[0] = 0.5;
  const auto found = minimizeLeastSquares(problem);
  ASSERT_EQ(found.status, LeastSquaresStatus::kConverged) << found.reason;
  EXPECT_LE(found.x[0], 0.5 + 1e-12);
  EXPECT_NEAR(found.x[0], 0.5, 1e-6);
  EXPECT_NEAR(found.x[1], 0.25, 1e-5);
}

TEST(LeastSquares, ScaledVariablesGiveTheSameAnswer) {
  auto problem = rosenbrock();
  problem.scale = Eigen::Vector2d(1e-2, 1e2);
  const auto found = minimizeLeastSquares(problem);
  EXPECT_NEAR(found.x[0], 1, 1e-6);
}

TEST(LeastSquares, SaysWhenItRanOutOfIterations) {
  const auto found = minimizeLeastSquares(rosenbrock(), {1e-12, 2});
  EXPECT_EQ(found.status, LeastSquaresStatus::kIterationLimit);
  EXPECT_FALSE(found.reason.empty());
}

TEST(LeastSquares, SaysWhenTheModelCannotBeEvaluated) {
  auto problem = rosenbrock();
  problem.evaluate = [](const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::MatrixXd*) { return false; };
  const auto found = minimizeLeastSquares(problem);
  EXPECT_EQ(found.status, LeastSquaresStatus::kFailed);
  EXPECT_FALSE(found.reason.empty());
}

}  // namespace
}  // namespace tubeplan::calibration
