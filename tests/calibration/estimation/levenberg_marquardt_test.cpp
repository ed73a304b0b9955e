#include <gtest/gtest.h>

#include "tests/calibration/estimation/known_problems.hpp"

namespace tubeplan::calibration {
namespace {

using Status = LeastSquaresStatus;

/// If the columns of the Jacobian are nearly equal, a step clipped at several bounds may predict an increase of chi2.
/// The method must then shorten the step, and converge to the same minimum as the interior point method.
TEST(LevenbergMarquardt, UnknownsAllButAlikeComeToRestAtTheirBounds) {
  int at_bounds = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto problem = randomLinear(seed, 0.1);
    const auto found = minimizeLeastSquares(problem, {1e-12, 10000, LeastSquaresMethod::kLevenbergMarquardt});
    ASSERT_EQ(found.status, Status::kConverged) << seed << ": " << found.reason;
    const auto other = minimizeLeastSquares(problem, {1e-10, 10000, LeastSquaresMethod::kInteriorPoint});
    EXPECT_NEAR(found.chi2, other.chi2, 1e-6 * other.chi2) << seed;
    at_bounds += ((found.x - problem.lower).array() == 0 || (problem.upper - found.x).array() == 0).count();
  }
  EXPECT_GT(at_bounds, 300);
}

}  // namespace
}  // namespace tubeplan::calibration
