// Repeated measurements at one posture must correct the stated noise, but only by a plausible factor: a larger scatter
// must not excuse a lack of fit.
#include "calibration/estimation/repeats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/patterns/comparison.hpp"
#include "tests/calibration/campaign.hpp"

namespace tubeplan::calibration {
namespace {

Comparison compared(const std::vector<Measurement>& measurements) {
  ComparisonOptions options;
  options.refit.folds = 0;
  return compare(placeForMeasurements(deflection::cobraArm(), Eigen::Isometry3d::Identity(), true, measurements),
                 measurements, options);
}

Comparison comparedWithNoise(double ratio, std::uint64_t seed) {
  CampaignPlan plan;
  plan.postures = 18;
  plan.repeats = 3;
  plan.noise = ratio * plan.stated;
  return compared(makeCampaign(deflection::cobraArm(), seed, plan));
}

TEST(Repeats, FindTheRatioOfTheNoise) {
  for (const double ratio : {1., 2., 5., 20.})
    EXPECT_NEAR(comparedWithNoise(ratio, 3).after_refit.repeats.noise_ratio, ratio, 0.25 * ratio);
}

TEST(Repeats, ExcuseAModelUpToTheirBoundOnly) {
  for (const auto& [ratio, verdict] : {std::pair{1., Adequacy::kAdequate}, std::pair{2., Adequacy::kAdequate},
                                       std::pair{5., Adequacy::kInadequate}, std::pair{50., Adequacy::kInadequate}})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Comparison result = comparedWithNoise(ratio, seed);
      EXPECT_EQ(result.verdict, verdict) << ratio << " times the stated noise, seed " << seed;
      EXPECT_EQ(areBeyondNoise(result.after_refit.repeats), ratio > kMostNoiseRatio) << ratio;
    }
}

// If each of two reflectors on the tool is measured twice at each posture, only measurements of the same reflector at
// the same posture must be treated as repeats.
TEST(Repeats, AreOfOnePlaceOnTheTool) {
  auto measurements = makeCampaign(deflection::cobraArm(), 4);
  measurements.resize(3);
  std::vector<Measurement> seen;
  for (const auto& measurement : measurements)
    for (const bool is_tip : {true, false, true, false}) {
      seen.push_back(measurement);
      seen.back().p_TQ.reset();
      if (!is_tip) seen.back().p_TQ = Eigen::Vector3d(0, 0, 0.08);
    }
  const auto groups = groupRepeats(seen);
  for (std::size_t a = 0; a < seen.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_EQ(groups[a] == groups[b], a / 4 == b / 4 && a % 2 == b % 2);
}

// If one measurement has the joint readings of the row before, so that two measurements at one posture are far apart,
// the scatter must not be treated as noise, and the model must be judged inadequate.
TEST(Repeats, AStaleRowIsNotNoise) {
  auto measurements = makeCampaign(deflection::cobraArm(), 4);
  measurements[20].q = measurements[19].q;
  measurements[20].load = measurements[19].load;
  measurements[20].approach_directions = measurements[19].approach_directions;
  const Comparison result = compared(measurements);
  ASSERT_EQ(result.after_refit.repeats.groups, 1);
  EXPECT_TRUE(areBeyondNoise(result.after_refit.repeats));
  EXPECT_EQ(result.verdict, Adequacy::kInadequate);
}

}  // namespace
}  // namespace tubeplan::calibration
