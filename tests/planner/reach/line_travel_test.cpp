#include "planner/reach/line_travel.hpp"

#include <gtest/gtest.h>

#include "planner/timing/flowing_timing.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::deflectedTip;
using testing::holeOf;
using testing::mockup;

constexpr double kTolerance = 0.002 * kInch;

/// Returns the standoff postures of a tube's branches.
std::vector<VectorXd> standoffsOf(const Workcell& cell, int tube) {
  std::vector<VectorXd> standoffs;
  for (const auto& branch : compensate(cell, holeOf(cell, tube)))
    if (branch.status == deflection::BranchStatus::kConverged) standoffs.push_back(branch.approach.front());
  return standoffs;
}

VectorXd nearest(const std::vector<VectorXd>& postures, const VectorXd& q) {
  return *std::ranges::min_element(postures, {}, [&](const VectorXd& other) { return (other - q).norm(); });
}

double distanceFromLine(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = (b - a).normalized();
  return (p - a - along * along.dot(p - a)).norm();
}

/// Returns the largest distance [m] of the tip from the straight line, from forward kinematics sampled along the timed
/// motion.
double sampledDeviation(const Workcell& cell, const LineTravel& line, const JointSpeeds& speeds) {
  const Vector3d a = deflectedTip(cell, line.waypoints.front()), b = deflectedTip(cell, line.waypoints.back());
  double worst = 0;
  const auto corners = cornersOf(timeFlow(line.waypoints, speeds));
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (const double s : {0.1, 0.3, 0.5, 0.7, 0.9})
      worst =
          std::max(worst, distanceFromLine(deflectedTip(cell, corners[k] + s * (corners[k + 1] - corners[k])), a, b));
  return worst;
}

TEST(LineTravel, KeepsTheDeflectedTipOnTheLineInTheSameBranch) {
  const Workcell cell = mockup();
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  LineTravels lines(cell, speeds);
  const auto tubes = testing::tubesOf(cell, "R20C10-50,-R20C11-19,-R20C21-29,-R20C31-39,-R20C41-49");
  ASSERT_EQ(tubes.size(), 5u);
  int joined = 0;
  for (std::size_t k = 0; k + 1 < tubes.size(); ++k)
    for (const VectorXd& q0 : standoffsOf(cell, tubes[k])) {
      const VectorXd q1 = nearest(standoffsOf(cell, tubes[k + 1]), q0);
      const LineTravel line = lines.between(q0, q1);
      if (line.status != LineTravelStatus::kOnLine) {
        EXPECT_FALSE(line.reason.empty());
        continue;
      }
      ++joined;
      EXPECT_EQ(line.waypoints.front(), q0);
      EXPECT_EQ(line.waypoints.back(), q1);
      EXPECT_LE(line.deviation, kTolerance);
      EXPECT_LE(sampledDeviation(cell, line, speeds), 1.1 * kTolerance) << tubes[k];
      const double straight = [&] {
        const Vector3d a = deflectedTip(cell, q0), b = deflectedTip(cell, q1);
        return distanceFromLine(deflectedTip(cell, (q0 + q1) / 2), a, b);
      }();
      EXPECT_GT(straight, 5 * kTolerance) << "the joint move itself would do: nothing is shown";
    }
  EXPECT_GE(joined, 5);
}

TEST(LineTravel, BetweenOtherBranchesThereIsNone) {
  Workcell cell = mockup();
  for (auto& row : cell.arm.rows) row.joint.lower = -3.2, row.joint.upper = 3.2;  // allows both positions of the elbow
  LineTravels lines(cell, jointSpeedsOf(cell.arm));
  const auto tubes = testing::tubesOf(cell, "R20C10,R20C50");
  int refused = 0;
  for (const VectorXd& q0 : standoffsOf(cell, tubes[0]))
    for (const VectorXd& q1 : standoffsOf(cell, tubes[1])) {
      if (q0[2] * q1[2] > 0) continue;  // skips pairs with the elbow on the same side
      const LineTravel line = lines.between(q0, q1);
      EXPECT_NE(line.status, LineTravelStatus::kOnLine);
      EXPECT_TRUE(line.waypoints.empty());
      EXPECT_FALSE(line.reason.empty());
      ++refused;
    }
  EXPECT_GE(refused, 1);
}

TEST(LineTravel, IsTheSameBackward) {
  const Workcell cell = mockup();
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  LineTravels lines(cell, speeds);
  const auto tubes = testing::tubesOf(cell, "R20C30,R20C40");
  const VectorXd q0 = standoffsOf(cell, tubes[0]).front(), q1 = nearest(standoffsOf(cell, tubes[1]), q0);
  const LineTravel forward = lines.between(q0, q1), backward = lines.between(q1, q0);
  ASSERT_EQ(forward.status, LineTravelStatus::kOnLine) << forward.reason;
  ASSERT_EQ(backward.status, LineTravelStatus::kOnLine) << backward.reason;
  ASSERT_EQ(forward.waypoints.size(), backward.waypoints.size());
  for (std::size_t k = 0; k < forward.waypoints.size(); ++k)
    EXPECT_LT((forward.waypoints[k] - backward.waypoints[backward.waypoints.size() - 1 - k]).norm(), 1e-8);
}

}  // namespace
}  // namespace tubeplan::planner
