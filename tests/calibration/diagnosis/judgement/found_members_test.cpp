// Joints that comply must be named alone, not with every joint of the arm.
#include "calibration/diagnosis/judgement/found_members.hpp"

#include <gtest/gtest.h>

#include <set>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::calibration {
namespace {

using SoftJoints = std::set<std::string>;

/// Returns the six-axis arm with rigid joints and links, on a known base. Its weights stay.
PlacedArm rigidSixAxes() {
  return {deflection::rigidCopy(deflection::sixAxisArm()), {{"", Eigen::Isometry3d::Identity(), true}}};
}

/// Returns 60 positions at random postures, with a noise of 0.05 mm.
std::vector<Measurement> positionsOf(const PlacedArm& truth, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Measurement> measurements(60);
  for (auto& measurement : measurements) {
    measurement.sigma = 5e-5;
    measurement.q.resize(truth.arm.jointCount());
    for (double& q : measurement.q) q = random.uniform(-2.4, 2.4);
    measurement.p_W = predictMeasurement(truth, measurement).value + random.vector(measurement.sigma);
  }
  return measurements;
}

SoftJoints diagnosed(const SoftJoints& soft, std::uint64_t seed) {
  PlacedArm truth = rigidSixAxes();
  for (auto& row : truth.arm.rows)
    if (soft.contains(row.name + ".z")) row.joint_stiffness.z() = row.name == "pitch" ? 5e3 : 1e5;
  const auto measurements = positionsOf(truth, seed);
  DiagnosisOptions options;
  options.baseline.free = {{"tool.tip", "geometry"}, false};
  const Diagnosis found = diagnose(rigidSixAxes(), measurements, options);
  SoftJoints names;
  if (found.alternatives.empty()) return names;
  for (const auto& effect : found.alternatives.front().effects)
    names.insert(effect.effect == std::string("joint-compliance") ? effect.at : effect.effect + "@" + effect.at);
  return names;
}

TEST(FoundMembers, TwoOrThreeSoftJointsAreNamedAlone) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed)
    for (const SoftJoints& soft : {SoftJoints{"shoulder.z", "elbow.z"}, SoftJoints{"shoulder.z", "elbow.z", "pitch.z"}})
      EXPECT_EQ(diagnosed(soft, seed), soft) << seed;
}

}  // namespace
}  // namespace tubeplan::calibration
