// Probabilities of discs and rings against the Rayleigh distribution, a Monte Carlo sum and difference quotients.
#include "calibration/watch/disc_probability.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Matrix2d, Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Matrix2d skewed() { return (Matrix2d() << 2.0, 0.6, 0.6, 0.5).finished(); }

TEST(DiscProbability, AboutTheMeanIsTheRayleighDistribution) {
  for (const double radius : {0.01, 0.5, 1., 3., 5.}) {
    const double exact = 1 - std::exp(-radius * radius / 2);
    EXPECT_NEAR(ringProbability(0, radius, Vector2d::Zero(), Matrix2d::Identity()).p, exact, 1e-8) << radius;
    EXPECT_NEAR(ringProbability(0, radius, 0.).p, exact, 1e-5) << radius;
    EXPECT_NEAR(ringProbability(radius, kInfinity, 0.).p, 1 - exact, 1e-5) << radius;
  }
}

TEST(DiscProbability, AgreesWithAMonteCarloSum) {
  RandomStream random(1);
  const Vector2d mean(0.8, -0.4);
  const Matrix2d L = skewed().llt().matrixL();
  int inside = 0;
  constexpr int kDraws = 200000;
  for (int k = 0; k < kDraws; ++k) {
    const double x = random.normal(1), y = random.normal(1);
    const double length = (mean + L * Vector2d(x, y)).norm();
    inside += length > 0.7 && length <= 2;
  }
  EXPECT_NEAR(ringProbability(0.7, 2, mean, skewed()).p, static_cast<double>(inside) / kDraws, 0.005);
}

TEST(DiscProbability, RingsOfAllOutcomesAddUpToOne) {
  for (const double away : {0., 1., 4., 20.}) {
    double radial = 0, plane = 0;
    for (const auto& [lower, upper] : {std::pair{0., 1.5}, {1.5, 6.}, {6., kInfinity}}) {
      radial += ringProbability(lower, upper, away).p;
      plane += ringProbability(lower, upper, Vector2d(0, away), skewed()).p;
    }
    EXPECT_NEAR(radial, 1, 1e-6);
    EXPECT_NEAR(plane, 1, 1e-6);
  }
}

TEST(DiscProbability, DerivativesAreThoseOfTheProbability) {
  constexpr double kStep = 1e-5;
  const Vector2d mean(1.1, 0.3);
  const auto at = [&](double x, double y) { return ringProbability(0.5, 2.5, mean + Vector2d(x, y), skewed()); };
  const RegionProbability ring = at(0, 0);
  EXPECT_NEAR(ring.slope.x(), (at(kStep, 0).p - at(-kStep, 0).p) / (2 * kStep), 1e-6);
  EXPECT_NEAR(ring.slope.y(), (at(0, kStep).p - at(0, -kStep).p) / (2 * kStep), 1e-6);
  EXPECT_NEAR(ring.curvature(0, 0), (at(kStep, 0).slope.x() - at(-kStep, 0).slope.x()) / (2 * kStep), 1e-5);
  EXPECT_NEAR(ring.curvature(0, 1), (at(0, kStep).slope.x() - at(0, -kStep).slope.x()) / (2 * kStep), 1e-5);
  EXPECT_NEAR(ring.curvature(1, 1), (at(0, kStep).slope.y() - at(0, -kStep).slope.y()) / (2 * kStep), 1e-5);
  const double away = 1.3;
  const double quotient =
      (ringProbability(0.5, 2.5, away + kStep).p - ringProbability(0.5, 2.5, away - kStep).p) / (2 * kStep);
  EXPECT_NEAR(ringProbability(0.5, 2.5, away).slope, quotient, 1e-4);
}

}  // namespace
}  // namespace tubeplan::calibration
