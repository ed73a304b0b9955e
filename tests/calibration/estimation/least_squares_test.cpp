// Every least-squares method of the table must solve problems with known solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/calibration/estimation/known_problems.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;
using Status = LeastSquaresStatus;

class EveryMethod : public testing::TestWithParam<std::string_view> {
 protected:
  LeastSquaresMethod method() const {
    for (const auto& kind : leastSquaresMethods())
      if (kind.name == GetParam()) return kind.method;
    throw std::logic_error("no such method");
  }
  LeastSquaresResult minimize(const LeastSquaresProblem& problem, std::optional<int> max_iterations = 100000) const {
    return minimizeLeastSquares(problem, {std::nullopt, max_iterations, method()});
  }
};

std::vector<std::string_view> methodNames() {
  std::vector<std::string_view> names;
  for (const auto& kind : leastSquaresMethods()) names.push_back(kind.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(LeastSquares, EveryMethod, testing::ValuesIn(methodNames()), [](const auto& tested) {
  std::string name(tested.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(EveryMethod, FindsTheBottomOfTheValley) {
  const auto found = minimize(rosenbrock());
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_NEAR(found.x[0], 1, 1e-4);
  EXPECT_NEAR(found.x[1], 1, 2e-4);
  EXPECT_DOUBLE_EQ(found.chi2, chi2Of(rosenbrock(), found.x));
}

// A method must report its iterations to the observer from start to end, and the observer must not change the result.
TEST_P(EveryMethod, TellsItsIterations) {
  std::vector<LeastSquaresIteration> iterations;
  LeastSquaresOptions options{std::nullopt, 100000, method()};
  const auto unwatched = minimizeLeastSquares(rosenbrock(), options);
  options.observe = [&](const LeastSquaresIteration& now) { iterations.push_back(now); };
  const auto found = minimizeLeastSquares(rosenbrock(), options);
  EXPECT_EQ(found.x, unwatched.x);
  EXPECT_EQ(found.evaluations, unwatched.evaluations);
  ASSERT_GE(iterations.size(), 2u);
  EXPECT_EQ(iterations.front().iteration, 0);
  EXPECT_EQ(iterations.front().step, 0);
  EXPECT_DOUBLE_EQ(iterations.front().chi2, chi2Of(rosenbrock(), rosenbrock().start));
  EXPECT_NEAR(iterations.back().chi2, found.chi2, 1e-9);
  for (const auto& now : iterations) {
    EXPECT_TRUE(std::any_of(leastSquaresMethods().begin(), leastSquaresMethods().end(), [&](const auto& kind) {
      return kind.name == now.method;
    })) << now.method;
    EXPECT_TRUE(std::isfinite(now.chi2) && now.step >= 0 && now.damping >= 0) << now.iteration;
  }
}

TEST_P(EveryMethod, StaysWithinBounds) {
  auto problem = rosenbrock();
  problem.upper[0] = 0.5;
  EvaluationCounts counts;
  const auto found = minimize(watched(problem, counts));
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_NEAR(found.x[0], 0.5, 1e-6);
  EXPECT_NEAR(found.x[1], 0.25, 1e-5);
  EXPECT_EQ(counts.out_of_bounds, 0);
}

/// At the solution of a linear problem, the gradient must be zero for each variable between its bounds; for a variable
/// at a bound, chi2 may decrease only beyond the bound.
TEST_P(EveryMethod, LinearProblemsEndWhereNoBoundLetsThemFallFurther) {
  int at_bounds = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EvaluationCounts counts;
    const auto problem = watched(randomLinear(seed), counts);
    const auto found = minimize(problem);
    ASSERT_EQ(found.status, Status::kConverged) << seed << ": " << found.reason;
    EXPECT_EQ(counts.out_of_bounds, 0);
    VectorXd r;
    MatrixXd J;
    problem.evaluate(found.x, r, &J);
    const VectorXd gradient = J.transpose() * r;
    for (int k = 0; k < gradient.size(); ++k) {
      const bool low = found.x[k]<problem.lower[k] + 1e-6, high = found.x[k]> problem.upper[k] - 1e-6;
      at_bounds += low || high;
      EXPECT_GE(gradient[k], high ? -kFar : -1e-4) << seed;
      EXPECT_LE(gradient[k], low ? kFar : 1e-4) << seed;
    }
  }
  EXPECT_GT(at_bounds, 20);
  EXPECT_LT(at_bounds, 80);
}

/// A problem stated in other units must give bitwise the same result, if the scales are powers of two.
TEST_P(EveryMethod, WorksInUnitsOfTheScale) {
  const Vector2d scale(0.25, 8);
  auto problem = rosenbrock(), stretched = rosenbrock();
  stretched.start = problem.start.cwiseProduct(scale);
  stretched.scale = scale;
  stretched.evaluate = [&](const VectorXd& x, VectorXd& r, MatrixXd* J) {
    const bool ok = problem.evaluate(x.cwiseQuotient(scale), r, J);
    if (J) *J = *J * scale.cwiseInverse().asDiagonal();
    return ok;
  };
  const auto found = minimize(problem), found_stretched = minimize(stretched);
  EXPECT_EQ(found_stretched.x, found.x.cwiseProduct(scale));
  EXPECT_EQ(found_stretched.evaluations, found.evaluations);
  EXPECT_EQ(found_stretched.jacobian_evaluations, found.jacobian_evaluations);
}

TEST_P(EveryMethod, CountsWhatItAsks) {
  auto bounded = rosenbrock();
  bounded.lower[1] = 1.5;
  for (const auto& problem : {rosenbrock(), bounded, halfPlane(true), halfPlane(false), randomLinear(3)})
    for (const int limit : {0, 1, 5, 100000}) {
      EvaluationCounts counts;
      const auto found = minimize(watched(problem, counts), limit);
      EXPECT_EQ(found.evaluations, counts.values);
      EXPECT_EQ(found.jacobian_evaluations, counts.jacobians);
      EXPECT_GT(counts.jacobians, 0);
      EXPECT_LE(found.iterations, limit);
    }
}

TEST_P(EveryMethod, SaysWhenItRanOutOfIterations) {
  const auto found = minimize(rosenbrock(), 2);
  EXPECT_EQ(found.status, Status::kIterationLimit);
  EXPECT_FALSE(found.reason.empty());
  EXPECT_EQ(found.iterations, 2);
  EXPECT_LT(found.chi2, chi2Of(rosenbrock(), rosenbrock().start));
  EXPECT_DOUBLE_EQ(found.chi2, chi2Of(rosenbrock(), found.x));
}

TEST_P(EveryMethod, AFinerToleranceWorksOnAndComesNoLessNear) {
  double last_off = kFar;
  int last_evaluations = 0;
  for (const double tolerance : {1e-1, 1e-3, 1e-5}) {
    const auto found = minimizeLeastSquares(rosenbrock(), {tolerance, 100000, method()});
    ASSERT_EQ(found.status, Status::kConverged) << found.reason;
    const double off = (found.x - Vector2d(1, 1)).norm();
    EXPECT_LE(off, last_off);
    EXPECT_GE(found.evaluations, last_evaluations);
    last_off = off;
    last_evaluations = found.evaluations;
  }
  EXPECT_LE(last_off, 1e-4);
}

TEST_P(EveryMethod, SaysWhenTheModelCannotBeEvaluatedAtAll) {
  for (const bool say_so : {true, false}) {
    auto problem = rosenbrock();
    problem.evaluate = [say_so](const VectorXd&, VectorXd& r, MatrixXd* J) {
      r = Vector2d::Constant(std::nan(""));
      if (J) *J = Eigen::Matrix2d::Zero();
      return !say_so;
    };
    const auto found = minimize(problem);
    EXPECT_EQ(found.status, Status::kFailed);
    EXPECT_FALSE(found.reason.empty());
    EXPECT_TRUE(std::isnan(found.chi2));
    EXPECT_EQ(found.x, problem.start);
  }
}

TEST_P(EveryMethod, TurnsBackWhereTheModelCannotBeEvaluated) {
  for (const bool say_so : {true, false}) {
    const auto found = minimize(halfPlane(say_so));
    ASSERT_EQ(found.status, Status::kConverged) << found.reason;
    EXPECT_NEAR(found.x[0], 1, 1e-5);
    EXPECT_NEAR(found.x[1], 1, 1e-5);
  }
}

/// If the Jacobian cannot be evaluated beyond x0 = 0.5, half way along the valley, the method must fail with a reason,
/// at a point with a smaller chi2 than the start.
TEST_P(EveryMethod, SaysWhenTheModelCannotBeDifferentiated) {
  auto problem = rosenbrock();
  problem.evaluate = [inner = problem.evaluate](const VectorXd& x, VectorXd& r, MatrixXd* J) {
    return inner(x, r, J) && !(J && x[0] > 0.5);
  };
  const auto found = minimize(problem);
  EXPECT_EQ(found.status, Status::kFailed) << found.reason;
  EXPECT_FALSE(found.reason.empty());
  EXPECT_LT(found.chi2, chi2Of(rosenbrock(), rosenbrock().start));
  EXPECT_DOUBLE_EQ(found.chi2, chi2Of(rosenbrock(), found.x));
}

TEST_P(EveryMethod, LeavesFixedVariablesWhereTheyAre) {
  auto problem = rosenbrock();
  problem.lower[0] = problem.upper[0] = 0.3;  // differs from the start
  EvaluationCounts counts;
  const auto found = minimize(watched(problem, counts));
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_EQ(found.x[0], 0.3);
  EXPECT_NEAR(found.x[1], 0.09, 1e-6);
  EXPECT_EQ(counts.out_of_bounds, 0);
}

TEST_P(EveryMethod, OnlyEvaluatesWhereEveryVariableIsFixed) {
  auto problem = rosenbrock();
  problem.lower = problem.upper = Vector2d(0.3, 0.4);
  EvaluationCounts counts;
  const auto found = minimize(watched(problem, counts));
  EXPECT_EQ(found.status, Status::kConverged);
  EXPECT_EQ(found.x, problem.lower);
  EXPECT_DOUBLE_EQ(found.chi2, 3.1 * 3.1 + 0.7 * 0.7);
  EXPECT_EQ(counts.values + counts.jacobians, 1);
  problem.evaluate = [](const VectorXd&, VectorXd&, MatrixXd*) { return false; };
  EXPECT_EQ(minimize(problem).status, Status::kFailed);
}

TEST_P(EveryMethod, StartsFromTheNearestPointWithinBounds) {
  auto problem = rosenbrock();
  problem.start = Vector2d(-50, 7);
  problem.lower = Vector2d(-1, -1);
  problem.upper = Vector2d(2, 2);
  EvaluationCounts counts;
  const auto found = minimize(watched(problem, counts));
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_NEAR(found.x[0], 1, 1e-4);
  EXPECT_NEAR(found.x[1], 1, 2e-4);
  EXPECT_EQ(counts.out_of_bounds, 0);
}

TEST_P(EveryMethod, RestsWhereNothingDependsOnTheVariables) {
  auto problem = rosenbrock();
  problem.evaluate = [](const VectorXd&, VectorXd& r, MatrixXd* J) {
    r = Vector2d(3, 4);
    if (J) *J = Eigen::Matrix2d::Zero();
    return true;
  };
  const auto found = minimize(problem);
  EXPECT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_DOUBLE_EQ(found.chi2, 25);
}

/// No evaluation may exceed a bound, even if dividing the bound by the scale and multiplying it again makes it larger
/// by rounding.
TEST_P(EveryMethod, BoundsHoldToTheLastBit) {
  auto problem = rosenbrock();
  problem.scale[0] = 0.3;
  problem.upper[0] = 0.7;
  ASSERT_GT(problem.upper[0] / problem.scale[0] * problem.scale[0], problem.upper[0]);
  EvaluationCounts counts;
  const auto found = minimize(watched(problem, counts));
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_EQ(counts.out_of_bounds, 0);
  EXPECT_LE(found.x[0], problem.upper[0]);
  EXPECT_NEAR(found.x[1], 0.49, 1e-4);
}

TEST_P(EveryMethod, RefusesBoundsTheWrongWayRound) {
  auto problem = rosenbrock();
  problem.lower[1] = 2;
  problem.upper[1] = 1;
  const auto found = minimize(problem);
  EXPECT_EQ(found.status, Status::kFailed);
  EXPECT_NE(found.reason.find("above its upper bound"), std::string::npos);
  EXPECT_EQ(found.evaluations + found.jacobian_evaluations, 0);
}

/// If chi2 is so large that its decrease is lost in rounding errors, every method must still converge in a reasonable
/// number of iterations.
TEST_P(EveryMethod, RestsOnALargeMisfit) {
  auto problem = rosenbrock();
  problem.evaluate = [inner = problem.evaluate](const VectorXd& x, VectorXd& r, MatrixXd* J) {
    inner(x, r, J);
    r = (VectorXd(4) << r.array() + 1e5, r.array() - 1e5).finished();
    if (J) *J = J->replicate<2, 1>().eval();
    return true;
  };
  const auto found = minimizeLeastSquares(problem, {1e-15, 100000, method()});
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_LT(found.iterations, 10000);
  EXPECT_NEAR(found.x[0], 1, 0.05);  // chi2 is 4e10 and its rounding 8e-6; a deviation of 0.05 changes chi2 by 5e-3
}

TEST(LeastSquaresMethods, EachHasItsOwnName) {
  std::set<std::string_view> names;
  std::set<LeastSquaresMethod> methods;
  for (const auto& kind : leastSquaresMethods()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_TRUE(methods.insert(kind.method).second) << kind.name;
  }
  EXPECT_TRUE(methods.contains(LeastSquaresOptions{}.method));
}

TEST(LeastSquaresMethods, TheInteriorPointIsExact) {
  const auto found = minimizeLeastSquares(rosenbrock(), {.method = LeastSquaresMethod::kInteriorPoint});
  ASSERT_EQ(found.status, Status::kConverged) << found.reason;
  EXPECT_NEAR(found.x[0], 1, 1e-8);
  EXPECT_NEAR(found.x[1], 1, 1e-8);
  EXPECT_NEAR(found.chi2, 0, 1e-14);
}

}  // namespace
}  // namespace tubeplan::calibration
