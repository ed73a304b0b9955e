#include "app/studies/measurements/measured_room.hpp"

#include <gtest/gtest.h>

#include "app/studies/measurements/discrimination_candidates.hpp"
#include "tests/calibration/bench_readings.hpp"

namespace tubeplan::app {
namespace {

class MeasuredRoomOfTheBench : public testing::Test {
 protected:
  Cell cell = calibration::shippedBench();
  std::vector<calibration::Measurement> readings = calibration::benchReadings(cell, "", "", {}, 40, 2);
  calibration::PlacedArm placed = calibration::benchStart(cell, readings);
  MeasuredRoom room{placed, readings};
};

TEST_F(MeasuredRoomOfTheBench, HoldsThePosturesThatWereMeasured) {
  for (const auto& reading : readings) EXPECT_TRUE(room.holds(reading.q, reading.load)) << reading.id;
}

TEST_F(MeasuredRoomOfTheBench, HoldsNoneThatHangsLower) {
  Eigen::VectorXd q = readings.front().q;
  q[1] = -60 * kDegree;
  q[2] = 0;
  EXPECT_FALSE(room.holds(q, 0));
}

TEST_F(MeasuredRoomOfTheBench, HoldsNoneThatFoldsTheArmOntoItself) {
  Eigen::VectorXd q = readings.front().q;
  q[1] = 90 * kDegree;
  q[2] = 178 * kDegree;  // the forearm folded onto the latch link; measured only up to 120 deg
  q[3] = 0;
  EXPECT_FALSE(room.holds(q, 0));
}

TEST_F(MeasuredRoomOfTheBench, ProposalsStayInIt) {
  const auto candidates = discriminationCandidates(cell, placed, readings);
  ASSERT_GT(candidates.size(), 20U);
  for (const auto& candidate : candidates)
    for (const auto& reading : candidate.readings) EXPECT_TRUE(room.holds(reading.q, reading.load));
}

}  // namespace
}  // namespace tubeplan::app
