// Simulated noisy measurements of the Cobra arm, and a function that adds an effect to the arm.
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <string>
#include <vector>

#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::calibration {

inline constexpr double kMeasurementSigma = 5e-5;  // [m]

inline deflection::Arm withEffect(deflection::Arm arm, const std::string& name, const std::string& at, double value) {
  auto made = deflection::makeEffect(arm, name, at);
  made.effect.values.front() = value;
  arm.effects.push_back(made.effect);
  return arm;
}

struct CampaignPlan {
  int postures = 36;
  int repeats = 1;
  /// Standard deviation of the noise added to each coordinate [m]; may differ from `stated`.
  double noise = kMeasurementSigma;
  double stated = kMeasurementSigma;
};

/// Returns tip positions measured under loads of 0, 60 and 120 N, alternating, with random approach directions and
/// temperatures, one measurement per minute. Joint readings contain encoder noise.
inline std::vector<Measurement> makeCampaign(const deflection::Arm& truth, std::uint64_t seed,
                                             const CampaignPlan& plan = {}) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> share(0, 1);
  boost::random::normal_distribution<double> normal;
  std::vector<Measurement> measurements;
  for (int posture = 0; posture < plan.postures; ++posture) {
    Measurement measurement;
    measurement.load = 60. * (posture % 3);
    measurement.q.resize(truth.jointCount());
    for (auto& q : measurement.q) q = -1 + 2 * share(random);
    measurement.q[1] += 1.2;
    for (Eigen::Index j = 0; j < truth.jointCount(); ++j)
      measurement.approach_directions.push_back(share(random) < 0.5 ? -1 : 1);
    measurement.conditions[Condition::kTemperature] =
        truth.reference[Condition::kTemperature] + 20 * (share(random) - 0.5);
    measurement.sigma = plan.stated;
    for (int again = 0; again < plan.repeats; ++again) {
      Measurement one = measurement;
      one.conditions[Condition::kTime] = 60. * static_cast<double>(measurements.size());
      one.id = std::to_string(measurements.size() + 1);
      one.p_W = predictMeasurement(truth, Eigen::Isometry3d::Identity(), one).value;
      for (int c = 0; c < 3; ++c) (*one.p_W)[c] += plan.noise * normal(random);
      for (Eigen::Index j = 0; j < truth.jointCount(); ++j) one.q[j] += truth.joint(j).encoder_sigma * normal(random);
      measurements.push_back(one);
    }
  }
  return measurements;
}

}  // namespace tubeplan::calibration
