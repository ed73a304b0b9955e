// A diagnosis must set aside measurements that give no information without an outlier, together with this outlier.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "calibration/diagnosis/diagnosis.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

TEST(Diagnosis, ATouchLeftAloneByAnOutlierIsSetAsideWithIt) {
  // Each unknown point is touched twice. If one of its touches is an outlier, the other one gives no information and
  // must be set aside too.
  for (const std::uint64_t seed : {1, 2, 3}) {
    MeasurementMaker maker(cobra(), seed, MeasurementMaker::Noise::kStated);
    maker.addTouches(24, {0, 40 * kPound}, false);
    auto measurements = maker.measurements;
    measurements[10].q[0] += 0.2 * kDegree;
    DiagnosisOptions options;
    options.baseline.free.names = {"tool.joint_stiffness.z", "mezzanine-platform.joint_stiffness.x"};
    const auto diagnosis = diagnose(cobra(), measurements, options);
    EXPECT_NE(diagnosis.verdict, Verdict::kNotRun) << diagnosis.reason;
    std::map<std::string, int> remaining;
    for (int k = 0; k < static_cast<int>(measurements.size()); ++k)
      if (!std::binary_search(diagnosis.set_aside.begin(), diagnosis.set_aside.end(), k))
        ++remaining[measurements[static_cast<std::size_t>(k)].point];
    for (const auto& [point, touches] : remaining) EXPECT_EQ(touches, 2) << point << ", seed " << seed;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
