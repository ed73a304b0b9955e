#include "app/studies/measurements/measured_room.hpp"

#include <gtest/gtest.h>

#include "app/studies/measurements/discrimination_candidates.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::app {
namespace {

class MeasuredRoomOfTheBench : public testing::Test {
 protected:
  Cell cell = calibration::shippedBench();
  std::vector<calibration::Measurement> measurements = calibration::benchMeasurements(cell, "", "", {}, 40, 2);
  calibration::PlacedArm placed = calibration::benchStart(cell, measurements);
  MeasuredRoom room{placed, measurements};
};

TEST_F(MeasuredRoomOfTheBench, HoldsThePosturesThatWereMeasured) {
  for (const auto& measurement : measurements)
    EXPECT_TRUE(room.contains(measurement.q, measurement.load)) << measurement.id;
}

TEST_F(MeasuredRoomOfTheBench, HoldsNoneThatHangsLower) {
  Eigen::VectorXd q = measurements.front().q;
  q[1] = -60 * kDegree;
  q[2] = 0;
  EXPECT_FALSE(room.contains(q, 0));
}

TEST_F(MeasuredRoomOfTheBench, HoldsNoneThatFoldsTheArmOntoItself) {
  Eigen::VectorXd q = measurements.front().q;
  q[1] = 90 * kDegree;
  q[2] = 178 * kDegree;  // the forearm folded onto the latch link; measured only up to 120 deg
  q[3] = 0;
  EXPECT_FALSE(room.contains(q, 0));
}

TEST_F(MeasuredRoomOfTheBench, ProposalsStayInIt) {
  const auto candidates = discriminationCandidates(cell, placed, measurements);
  ASSERT_GT(candidates.size(), 20U);
  for (const auto& candidate : candidates)
    for (const auto& measurement : candidate.measurements) EXPECT_TRUE(room.contains(measurement.q, measurement.load));
}

}  // namespace
}  // namespace tubeplan::app
