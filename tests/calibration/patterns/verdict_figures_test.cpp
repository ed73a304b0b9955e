// No verdict contradicts the figures that it comes with, whatever was done to the readings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/patterns/comparison.hpp"
#include "calibration/statistics.hpp"
#include "tests/calibration/campaign.hpp"

namespace tubeplan::calibration {
namespace {

using Readings = std::vector<Measurement>;
using Random = std::mt19937_64;

constexpr double kSlack = 1.2;  // of an rms by chance

std::size_t drawn(const Readings& readings, Random& random) {
  return std::uniform_int_distribution<std::size_t>(1, readings.size() - 1)(random);
}
void moved(Measurement& reading, double by, Random& random) {
  std::normal_distribution<double> normal(0, by);
  for (double& p : *reading.p_W) p += normal(random);
}

/// One way to spoil readings; the first does nothing.
struct Spoil {
  const char* name;
  int repeats;  ///< of each posture
  std::function<void(Readings&, Random&)> apply;
};

const std::vector<Spoil>& spoils() {
  static const std::vector<Spoil> kSpoils{
      {"nothing", 1, [](Readings&, Random&) {}},
      {"nothing, read twice", 2, [](Readings&, Random&) {}},
      {"the joints of the row before", 1, [](Readings& readings, Random& random) {
         const std::size_t k = drawn(readings, random);
         readings[k].q = readings[k - 1].q;
         readings[k].load = readings[k - 1].load;
         readings[k].approach_directions = readings[k - 1].approach_directions;
       }},
      {"half of the joints of the rows before", 1, [](Readings& readings, Random&) {
         for (std::size_t k = 1; k < readings.size(); k += 2) {
           readings[k].q = readings[k - 1].q;
           readings[k].load = readings[k - 1].load;
           readings[k].approach_directions = readings[k - 1].approach_directions;
         }
       }},
      {"places in another order", 2, [](Readings& readings, Random& random) {
         std::vector<Eigen::Vector3d> places;
         for (const auto& reading : readings) places.push_back(*reading.p_W);
         std::shuffle(places.begin(), places.end(), random);
         for (std::size_t k = 0; k < readings.size(); ++k) readings[k].p_W = places[k];
       }},
      {"one place 100 sigmas off", 1, [](Readings& readings, Random& random) {
         moved(readings[drawn(readings, random)], 100 * kReadingSigma, random);
       }},
      {"every tenth place 100 sigmas off", 2, [](Readings& readings, Random& random) {
         for (std::size_t k = 0; k < readings.size(); k += 10) moved(readings[k], 100 * kReadingSigma, random);
       }},
      {"places twice as noisy as stated", 2, [](Readings& readings, Random& random) {
         for (auto& reading : readings) moved(reading, std::sqrt(3.) * kReadingSigma, random);
       }},
      {"places thirty times as noisy as stated", 2, [](Readings& readings, Random& random) {
         for (auto& reading : readings) moved(reading, 30 * kReadingSigma, random);
       }},
      {"a joint's sign", 2, [](Readings& readings, Random&) {
         for (auto& reading : readings) reading.q[2] *= -1;
       }},
      {"places 2 % too long", 1, [](Readings& readings, Random&) {
         for (auto& reading : readings) *reading.p_W *= 1.02;
       }},
  };
  return kSpoils;
}

class VerdictFigures : public testing::TestWithParam<std::size_t> {
 protected:
  const Spoil& spoil() const { return spoils()[GetParam()]; }
  Readings readings(std::uint64_t seed) const {
    Random random(seed);
    CampaignPlan plan;
    plan.postures = 40 / spoil().repeats;
    plan.repeats = spoil().repeats;
    Readings made = makeCampaign(deflection::cobraArm(), seed, plan);
    spoil().apply(made, random);
    return made;
  }
  static PlacedArm start(const Readings& readings) {
    return placeForReadings(deflection::cobraArm(), Eigen::Isometry3d::Identity(), true, readings);
  }
};

bool excuses(const Repeats& repeats) {
  return repeats.groups > 0 && repeats.noise_ratio <= kMostNoiseRatio && repeats.lack_of_fit_p_value >= kLackOfFit;
}

TEST_P(VerdictFigures, OfAComparisonAgree) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const auto& free : std::vector<std::vector<std::string>>{{}, {"tool.joint_stiffness.z"}}) {
      const Readings made = readings(seed);
      ComparisonOptions options;
      options.refit.free = {free, true};
      options.refit.folds = 0;
      options.refit.intervals_by_profile = false;
      const Comparison result = compare(start(made), made, options);
      ASSERT_EQ(result.status, ComparisonStatus::kDone) << result.reason;
      const ModelLackOfFit& fit = result.after_refit;
      const std::string what = std::string(spoil().name) + ", seed " + std::to_string(seed);
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
  const Readings made = readings(3);
  DiagnosisOptions options;
  options.baseline.free = {{"tool.joint_stiffness.z"}, true};
  const Diagnosis result = diagnose(start(made), made, options);
  if (result.verdict == Verdict::kAdequate) {
    EXPECT_LE(result.before.rms, kSlack * kMostNoiseRatio * result.noise_floor) << spoil().name;
  }
  if (result.verdict == Verdict::kExplained || result.verdict == Verdict::kPartlyExplained) {
    EXPECT_LT(result.heldout_after.rms, result.heldout_before.rms) << spoil().name;
    EXPECT_LT(result.after.rms, result.before.rms) << spoil().name;
  }
  if (result.verdict == Verdict::kExplained) {
    EXPECT_LE(result.after.rms, kSlack * kMostNoiseRatio * result.noise_floor) << spoil().name;
  }
  for (const double probability : {result.nothing_probability, result.unknown_probability, result.scatter_probability})
    if (std::isfinite(probability)) {
      EXPECT_GE(probability, -1e-9) << spoil().name;
      EXPECT_LE(probability, 1 + 1e-9) << spoil().name;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEverySpoil, VerdictFigures, testing::Range<std::size_t>(0, spoils().size()));

}  // namespace
}  // namespace tubeplan::calibration
