#include "planner/reach/line_travel.hpp"

#include <gtest/gtest.h>

#include "planner/timing/flowing_timing.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::deflectedTip;
using testing::holeOf;
using testing::kInch;
using testing::mockup;

constexpr double kTolerance = 0.002 * kInch;

/// The standoff of a branch of a tube.
VectorXd standoffOf(const Workcell& cell, int tube, std::size_t branch) {
  auto branches = compensate(cell, holeOf(cell, tube));
  std::erase_if(branches, [](const TubeBranch& b) { return b.status != deflection::BranchStatus::kConverged; });
  return branch < branches.size() ? branches[branch].approach.front() : VectorXd();
}

double distanceFromLine(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = (b - a).normalized();
  return (p - a - along * along.dot(p - a)).norm();
}

/// Most the tip, by the kinematics alone, leaves the line along the flow as it is driven.
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
  const auto tubes = testing::tubesOf(cell, "spread:6");
  int joined = 0;
  for (std::size_t k = 0; k + 1 < tubes.size(); ++k)
    for (std::size_t branch = 0; branch < 2; ++branch) {
      const VectorXd q0 = standoffOf(cell, tubes[k], branch), q1 = standoffOf(cell, tubes[k + 1], branch);
      if (q0.size() == 0 || q1.size() == 0) continue;
      const LineTravel line = lines.between(q0, q1);
      if (line.status != LineTravelStatus::kOnLine) {
        EXPECT_FALSE(line.reason.empty());
        continue;
      }
      ++joined;
      EXPECT_EQ(line.waypoints.front(), q0);
      EXPECT_EQ(line.waypoints.back(), q1);
      EXPECT_LE(line.deviation, kTolerance);
      EXPECT_LE(sampledDeviation(cell, line, speeds), 1.1 * kTolerance) << tubes[k] << " branch " << branch;
      const double straight = [&] {
        const Vector3d a = deflectedTip(cell, q0), b = deflectedTip(cell, q1);
        return distanceFromLine(deflectedTip(cell, (q0 + q1) / 2), a, b);
      }();
      EXPECT_GT(straight, 5 * kTolerance) << "the joint move itself would do: nothing is shown";
    }
  EXPECT_GE(joined, 5);
}

TEST(LineTravel, BetweenOtherBranchesIsRefusedInWords) {
  const Workcell cell = mockup();
  LineTravels lines(cell, jointSpeedsOf(cell.arm));
  const auto tubes = testing::tubesOf(cell, "spread:4");
  int refused = 0;
  for (const int tube : tubes) {
    const VectorXd q0 = standoffOf(cell, tube, 0), q1 = standoffOf(cell, tube, 1);
    const VectorXd far = standoffOf(cell, tubes.front() == tube ? tubes.back() : tubes.front(), 1);
    if (q0.size() == 0 || q1.size() == 0 || far.size() == 0 || (q0 - q1).norm() < 0.1) continue;
    const LineTravel line = lines.between(q0, far);
    if (line.status == LineTravelStatus::kOnLine) continue;  // the branches are numbered by hole
    ++refused;
    EXPECT_TRUE(line.waypoints.empty());
    EXPECT_FALSE(line.reason.empty());
  }
  EXPECT_GE(refused, 1);
}

TEST(LineTravel, IsTheSameBackward) {
  const Workcell cell = mockup();
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  LineTravels lines(cell, speeds);
  const auto tubes = testing::tubesOf(cell, "spread:6");
  const VectorXd q0 = standoffOf(cell, tubes[2], 0), q1 = standoffOf(cell, tubes[3], 0);
  const LineTravel there = lines.between(q0, q1), back = lines.between(q1, q0);
  ASSERT_EQ(there.status, back.status);
  ASSERT_EQ(there.waypoints.size(), back.waypoints.size());
  for (std::size_t k = 0; k < there.waypoints.size(); ++k)
    EXPECT_LT((there.waypoints[k] - back.waypoints[back.waypoints.size() - 1 - k]).norm(), 1e-8);
}

}  // namespace
}  // namespace tubeplan::planner
