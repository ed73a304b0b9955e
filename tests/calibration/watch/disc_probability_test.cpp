// Probabilities of the common part of discs against the Rayleigh distribution, a Monte Carlo sum, the step model of
// plans, and difference quotients.
#include "calibration/watch/disc_probability.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "calibration/random_stream.hpp"
#include "calibration/watch/counted_steps.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Matrix2d, Eigen::Vector2d;

Matrix2d skewed() { return (Matrix2d() << 2.0, 0.6, 0.6, 0.5).finished(); }

/// One disc, a lens, and a corner of three discs.
const std::vector<CommonDiscs>& families() {
  static const std::vector<CommonDiscs> kFamilies{
      {{{0, 0}, 2}},
      {{{-1, 0.5}, 2}, {{1.2, 0}, 2.2}},
      {{{0, 0}, 2}, {{2, 0}, 2}, {{1, 1.5}, 1.8}},
  };
  return kFamilies;
}

/// A tool whose steps have lengths, in standard deviations of an offset.
tubesheets::SteppedTool longTool() { return {{{10, 3}, {11, 2}, {12, 1}}, {20, 25, 15}}; }

TEST(DiscProbability, AboutTheMeanIsTheRayleighDistribution) {
  for (const double radius : {0.01, 0.5, 1., 3., 5.}) {
    const double exact = 1 - std::exp(-radius * radius / 2);
    EXPECT_NEAR(probabilityWithin({{{0, 0}, radius}}, Vector2d::Zero(), Matrix2d::Identity()).p, exact, 1e-8) << radius;
  }
}

TEST(DiscProbability, AgreesWithAMonteCarloSum) {
  const Vector2d mean(0.8, -0.4);
  const Matrix2d L = skewed().llt().matrixL();
  constexpr int kDraws = 200000;
  for (const CommonDiscs& discs : families()) {
    RandomStream random(1);
    int inside = 0;
    for (int k = 0; k < kDraws; ++k) {
      const double x = random.normal(1), y = random.normal(1);
      const Vector2d point = mean + L * Vector2d(x, y);
      bool is_in = true;
      for (const Disc& disc : discs) is_in = is_in && (point - disc.centre).norm() <= disc.radius;
      inside += is_in;
    }
    EXPECT_NEAR(probabilityWithin(discs, mean, skewed()).p, static_cast<double>(inside) / kDraws, 0.005);
  }
}

TEST(DiscProbability, DerivativesAreThoseOfTheProbability) {
  constexpr double kStep = 1e-5;
  const Vector2d mean(1.1, 0.3);
  for (const CommonDiscs& discs : families()) {
    const auto at = [&](double x, double y) { return probabilityWithin(discs, mean + Vector2d(x, y), skewed()); };
    const RegionProbability centre = at(0, 0);
    EXPECT_NEAR(centre.slope.x(), (at(kStep, 0).p - at(-kStep, 0).p) / (2 * kStep), 1e-6);
    EXPECT_NEAR(centre.slope.y(), (at(0, kStep).p - at(0, -kStep).p) / (2 * kStep), 1e-6);
    EXPECT_NEAR(centre.curvature(0, 0), (at(kStep, 0).slope.x() - at(-kStep, 0).slope.x()) / (2 * kStep), 1e-5);
    EXPECT_NEAR(centre.curvature(0, 1), (at(0, kStep).slope.x() - at(0, -kStep).slope.x()) / (2 * kStep), 1e-5);
    EXPECT_NEAR(centre.curvature(1, 1), (at(0, kStep).slope.y() - at(0, -kStep).slope.y()) / (2 * kStep), 1e-5);
  }
}

TEST(DiscProbability, IsTheSameWithoutTheNeedlessDiscs) {
  CommonDiscs discs = families()[1];
  discs.insert(discs.begin(), {{0, 0}, 9});
  discs.push_back(discs.back());
  EXPECT_EQ(withoutRedundant(discs).size(), 2U);
  EXPECT_DOUBLE_EQ(probabilityWithin(discs, Vector2d(1, 0), skewed()).p,
                   probabilityWithin(families()[1], Vector2d(1, 0), skewed()).p);
  EXPECT_EQ(withoutRedundant({{{0, 0}, 2}, {{0, 0}, -1}}).size(), 1U);
  EXPECT_EQ(probabilityWithin({{{0, 0}, -1}}, Vector2d::Zero(), skewed()).p, 0);
}

TEST(CountedSteps, HaveTheProbabilitiesOfPlans) {
  const Vector2d tip(0.4, -0.2);
  for (const bool has_lengths : {false, true})
    for (const Vector2d& lean : {Vector2d(0, 0), Vector2d(0.01, -0.005), Vector2d(-0.04, 0.05), Vector2d(0.3, 0.1)}) {
      tubesheets::SteppedTool tool = longTool();
      if (!has_lengths) tool.lengths.clear();
      const auto expected = tubesheets::probabilityBySteps(tool, tip, skewed(), lean);
      const CountedSteps count = countedSteps(tool, lean, 1, 0);
      ASSERT_EQ(count.outcomes(), 4);
      for (int k = 0; k < count.outcomes(); ++k) {
        const Vector2d section = tip - midDepthOfLastStep(tool) * lean;
        EXPECT_NEAR(probabilityOf(count, k, section, skewed()).p, expected[static_cast<std::size_t>(k)], 1e-5) << lean;
      }
    }
}

}  // namespace
}  // namespace tubeplan::calibration
