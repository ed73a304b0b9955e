// Fits of the geometry of random arms in Denavit-Hartenberg parameters on a known base, which also include the first
// axis.
#include <gtest/gtest.h>

#include "calibration/estimation/identification.hpp"
#include "calibration/independent_geometry.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/estimation/freeing.hpp"
#include "tests/calibration/random_mechanisms.hpp"

namespace tubeplan::calibration {
namespace {

constexpr double kTrackerSigma = 5e-5;  // [m]

/// Returns the arm as built: every frame deviates from the drawing in all six directions, with standard deviations of 2
/// mm and 4 mrad.
deflection::Arm builtFrom(const PlacedArm& drawn, RandomStream& random) {
  deflection::Arm built = byOrigins(drawn).arm;
  for (auto& row : built.rows) {
    auto& origin = std::get<deflection::Origin<double>>(row.placement);
    origin.position += random.vector(0.002);
    origin.rpy += random.vector(0.004);
  }
  return built;
}

/// Returns noise-free measurements of the tip position at random postures over the joints' whole ranges.
std::vector<Measurement> exactPositions(const deflection::Arm& arm, RandomStream& random) {
  std::vector<Measurement> measurements(120);
  for (Measurement& m : measurements) {
    m.id = std::to_string(&m - measurements.data() + 1);
    m.q.resize(arm.jointCount());
    for (Eigen::Index j = 0; j < m.q.size(); ++j) m.q[j] = random.uniform(arm.joint(j).lower, arm.joint(j).upper);
    m.sigma = kTrackerSigma;
    m.p_W = predictMeasurement(arm, Eigen::Isometry3d::Identity(), m).value;
  }
  return measurements;
}

TEST(KnownBase, LeavesNothingOfARandomArmsGeometryUnexplained) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    for (PlacedArm drawn : {mechanism(seed), byStandardTable(mechanism(seed))}) {
      SCOPED_TRACE(testing::Message() << seed << (deflection::isStandard(drawn.arm.rows) ? " standard" : " modified"));
      drawn.base_poses[0].is_known = true;
      RandomStream random(100 + seed);
      const auto measurements = exactPositions(builtFrom(drawn, random), random);
      const Identification found = identify(drawn, measurements, freeing({"geometry"}));
      ASSERT_EQ(found.status, IdentificationStatus::kDone) << found.reason;
      EXPECT_GT(found.before.rms, 10 * kTrackerSigma);
      EXPECT_LT(found.after.rms, 0.1 * kTrackerSigma);
    }
}

TEST(KnownBase, FreesTheShiftOfTheFirstAxisAndAFreeBaseDoesNot) {
  int turning = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    for (const bool is_known : {true, false})
      for (PlacedArm drawn : {mechanism(seed), byStandardTable(mechanism(seed))}) {
        if (drawn.arm.joint(0).type != deflection::JointType::kRevolute) continue;
        ++turning;
        drawn.base_poses[0].is_known = is_known;
        int shifts = 0;
        for (const auto& unknown : chooseUnknowns(drawn, {{"geometry"}, true}).list)
          shifts += isShiftOfFirstAxis(unknown.name);
        EXPECT_EQ(shifts, is_known ? 1 : 0) << seed;
      }
  EXPECT_GT(turning, 60);
  const PlacedArm drawn = mechanism(3), standard = byStandardTable(drawn);
  for (const auto& name : namesBehind(drawn.arm, "link1.dh")) EXPECT_NE(name, "link1.dh.b");
  for (const auto& name : namesBehind(standard.arm, "link1.axis")) EXPECT_NE(name, "link1.axis.b");
  EXPECT_FALSE(deflection::findParameter(drawn.arm, "link2.dh.b"));
  EXPECT_FALSE(deflection::findParameter(standard.arm, "link1.dh.b"));
  EXPECT_TRUE(deflection::findParameter(standard.arm, "link1.axis.b"));
}

}  // namespace
}  // namespace tubeplan::calibration
