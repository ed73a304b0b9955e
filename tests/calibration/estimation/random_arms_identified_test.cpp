// Stiffnesses of random arms must be recovered from exact measurements, as far as these determine them.
#include <gtest/gtest.h>

#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/estimation/freeing.hpp"
#include "tests/deflection/random_arms.hpp"

namespace tubeplan::calibration {
namespace {

using namespace deflection;

/// Returns noise-free measurements of the tip position at random postures, under three alternating loads.
std::vector<Measurement> exactMeasurements(const Arm& arm, int count) {
  std::vector<Measurement> measurements;
  for (int k = 0; k < count; ++k) {
    const Posture posture = randomPostureOf(arm, 300);
    Measurement m;
    m.id = std::to_string(k + 1);
    m.q = posture.q;
    m.side_q = posture.side_q;
    m.load = 100. * (k % 3);
    if (posture.wrench) m.wrench = TipWrench{posture.wrench->force_B, posture.wrench->moment_B};
    m.sigma = 5e-5;
    const auto predicted = predictMeasurement(arm, Eigen::Isometry3d::Identity(), m);
    RC_PRE(predicted.ok);
    m.p_W = predicted.value;
    measurements.push_back(m);
  }
  return measurements;
}

bool isStiff(const Arm& arm, const std::vector<Measurement>& measurements) {
  return std::all_of(measurements.begin(), measurements.end(), [&](const Measurement& m) {
    return isModest(arm, solveFlexibleKinematics(arm, postureOf(m, arm, Eigen::Isometry3d::Identity())));
  });
}

RC_GTEST_PROP(RandomArms, AreIdentified, ()) {
  const Arm arm = randomArm();
  const auto measurements = exactMeasurements(arm, 24);
  RC_PRE(isStiff(arm, measurements));
  IdentificationOptions options = freeingBlindly({});
  PlacedArm start{arm, {{"", Eigen::Isometry3d::Identity(), true}}};
  for (const auto& parameter : parametersOf(arm)) {
    const bool is_joint = parameter.name.find("joint_stiffness") != std::string::npos;
    if (!is_joint || options.free.names.size() >= 6) continue;
    options.free.names.push_back(parameter.name);
    locate(start.arm, parameter.path) *= below(2) ? 1.5 : 1 / 1.5;
  }
  RC_PRE(!options.free.names.empty());
  const auto found = identify(start, measurements, options);
  RC_CLASSIFY(found.status == IdentificationStatus::kDone, "done");
  if (found.status != IdentificationStatus::kDone) {
    RC_ASSERT(!found.reason.empty());
    return;
  }
  // Stiffnesses that the measurements do not determine may keep their start values, but the fit must reproduce the
  // measurements.
  RC_ASSERT(found.after.rms <= 0.02 * 5e-5 + 1e-4 * found.before.rms);
  for (const auto& number : found.numbers) {
    const double value = findParameter(arm, number.unknown.name)->value;
    if (number.upper - number.lower < 0.01 * value) RC_ASSERT(std::abs(number.value - value) < 0.01 * value);
  }
}

}  // namespace
}  // namespace tubeplan::calibration
