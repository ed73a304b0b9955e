// No verdict may contradict the figures reported with it, no matter how the measurements were corrupted.
#include <gtest/gtest.h>

#include <cmath>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/patterns/comparison.hpp"
#include "calibration/statistics.hpp"
#include "tests/calibration/measurement_faults.hpp"

namespace tubeplan::calibration {
namespace {

constexpr double kSlack = 1.2;  // allowed random variation of a root mean square

class VerdictFigures : public testing::TestWithParam<std::size_t> {
 protected:
  const MeasurementFault& fault() const { return measurementFaults()[GetParam()]; }
  std::vector<Measurement> measurements(std::uint64_t seed) const {
    return campaignWithFault(deflection::cobraArm(), seed, fault());
  }
  static PlacedArm start(const std::vector<Measurement>& measurements) {
    return placeForMeasurements(deflection::cobraArm(), Eigen::Isometry3d::Identity(), true, measurements);
  }
};

bool excuses(const Repeats& repeats) {
  return repeats.groups > 0 && repeats.noise_ratio <= kMostNoiseRatio && repeats.lack_of_fit_p_value >= kLackOfFit;
}

TEST_P(VerdictFigures, OfAComparisonAgree) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const auto& free : std::vector<std::vector<std::string>>{{}, {"tool.joint_stiffness.z"}}) {
      const std::vector<Measurement> made = measurements(seed);
      ComparisonOptions options;
      options.refit.free = {free, true};
      options.refit.folds = 0;
      options.refit.intervals_by_profile = false;
      const Comparison result = compare(start(made), made, options);
      ASSERT_EQ(result.status, ComparisonStatus::kDone) << result.reason;
      const ModelLackOfFit& fit = result.after_refit;
      const std::string what = std::string(fault().name) + ", seed " + std::to_string(seed);
      if (result.verdict == Adequacy::kAdequate) {
        EXPECT_LE(fit.errors.rms, kSlack * kMostNoiseRatio * fit.noise_floor) << what;
        EXPECT_TRUE(fit.p_value >= options.level || excuses(fit.repeats)) << what << ", p " << fit.p_value;
      } else if (result.verdict == Adequacy::kInadequate) {
        EXPECT_FALSE(result.grounds.empty()) << what;
      }
      if (fit.errors.rms > kSlack * kMostNoiseRatio * fit.noise_floor) {
        EXPECT_EQ(result.verdict, Adequacy::kInadequate) << what;
      }
    }
}

TEST_P(VerdictFigures, OfADiagnosisAgree) {
  const std::vector<Measurement> made = measurements(3);
  DiagnosisOptions options;
  options.baseline.free = {{"tool.joint_stiffness.z"}, true};
  const Diagnosis result = diagnose(start(made), made, options);
  if (result.verdict == Verdict::kAdequate) {
    EXPECT_LE(result.before.rms, kSlack * kMostNoiseRatio * result.noise_floor) << fault().name;
  }
  if (result.verdict == Verdict::kExplained || result.verdict == Verdict::kPartlyExplained) {
    EXPECT_LT(result.heldout_after.rms, result.heldout_before.rms) << fault().name;
    EXPECT_LT(result.after.rms, result.before.rms) << fault().name;
  }
  if (result.verdict == Verdict::kExplained) {
    EXPECT_LE(result.after.rms, kSlack * kMostNoiseRatio * result.noise_floor) << fault().name;
  }
  for (const double probability : {result.nothing_probability, result.unknown_probability, result.scatter_probability})
    if (std::isfinite(probability)) {
      EXPECT_GE(probability, -1e-9) << fault().name;
      EXPECT_LE(probability, 1 + 1e-9) << fault().name;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryFault, VerdictFigures, testing::Range<std::size_t>(0, measurementFaults().size()));

}  // namespace
}  // namespace tubeplan::calibration
