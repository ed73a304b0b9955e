#include "deflection/anchored_rows.hpp"

#include <gtest/gtest.h>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/row_conventions.hpp"
#include "tests/deflection/drawn_rows.hpp"

namespace tubeplan::deflection {
namespace {

using testing::DrawnRows;

/// Returns the arm as a controller would state it, with exact common normals even between nearly parallel axes.
Arm byCommonNormals(const Arm& arm) { return convertRows(arm, RowConvention::kModified, {.nearly_parallel = 0}).arm; }

TEST(AnchoredRows, areTheSameArmHoweverFarItsRowsGo) {
  DrawnRows draw(11);
  int far = 0;
  for (int n = 0; n < 400; ++n) {
    const Arm arm = draw.arm(2 + n % 7);
    const Arm written = byCommonNormals(arm);
    const AnchoredRows anchored = anchoredRows(written);
    far += testing::longestRow(written) > 100;
    const double rounding = 1e-14 * testing::longestRow(written) + 1e-12;
    EXPECT_LE(testing::formDifference(arm, anchored.arm, draw.readings(arm)), rounding) << n;
    EXPECT_LT(testing::longestRow(anchored.arm), 6) << n;
    EXPECT_NEAR(reachOf(written), reachOf(arm), 1e-7 * reachOf(arm)) << n;
  }
  EXPECT_GT(far, 100);
}

TEST(AnchoredRows, leaveAnArmThatIsWrittenNearAsItIs) {
  DrawnRows draw(12);
  Arm arm = draw.arm(6, true);
  for (auto& row : arm.rows) row.placement = DenavitHartenberg<double>{1.2, 0.3, 0.1, 0.4};
  const AnchoredRows anchored = anchoredRows(arm);
  for (const double slid : anchored.slid) EXPECT_EQ(slid, 0);
  EXPECT_TRUE(std::holds_alternative<DenavitHartenberg<double>>(anchored.arm.rows[3].placement));
}

TEST(AnchoredRows, holdRowsThatBendOrWeighAtTheirOrigins) {
  DrawnRows draw(13);
  Arm arm = byCommonNormals(draw.arm(6, true));
  arm.rows[2].weight.distributed = 5;
  arm.rows[4].joint_stiffness.y() = 1e5;
  const AnchoredRows anchored = anchoredRows(arm);
  for (const std::size_t k : {2u, 3u, 4u}) {
    EXPECT_FALSE(heldAgainstSlide(arm, k).empty());
    EXPECT_EQ(anchored.slid[k], 0) << k;
  }
  EXPECT_LE(testing::formDifference(arm, anchored.arm, draw.readings(arm)), 1e-14 * testing::longestRow(arm) + 1e-12);
}

/// Returns a cobot whose three middle axes are parallel and whose other axes are at right angles, except for small
/// errors.
Arm cobot() {
  constexpr double kRight = std::numbers::pi / 2;
  Arm arm;
  const Origin<double> places[] = {{{0, 0, 0.16}, {0, 0, 0}},         {{0, 0, 0}, {kRight + 4e-4, 3e-4, 0}},
                                   {{-0.5, 0, 0}, {2e-4, 6e-4, 0}},   {{-0.4, 0, 0.12}, {-5e-4, 2e-4, 0}},
                                   {{0, -0.1, 0}, {kRight, 1e-4, 0}}, {{0, 0.1, 0}, {-kRight, -3e-4, 0}}};
  for (const auto& place : places) {
    auto& row = arm.rows.emplace_back();
    row.name = "link" + std::to_string(arm.rows.size());
    row.placement = place;
    row.joint = {.name = "q" + std::to_string(arm.rows.size()), .type = JointType::kRevolute, .lower = -6, .upper = 6};
  }
  arm.p_LT = {0, 0, 0.12};
  return arm;
}

TEST(AnchoredRows, inverseKinematicsFindsTheSameBranches) {
  const Arm arm = cobot(), written = byCommonNormals(arm);
  EXPECT_GT(testing::longestRow(written), 300);
  EXPECT_NEAR(reachOf(written), reachOf(arm), 1e-9);
  DrawnRows draw(14);
  int found = 0;
  for (int n = 0; n < 12; ++n) {
    const auto frames = rigidFramesOf<double>(arm, draw.readings(arm));
    const ToolGoal goal{frames.tip, frames.rows.back().R.col(2)};
    const auto one = solveInverseKinematics(arm, goal, 0, -Eigen::Vector3d::UnitZ());
    const auto other = solveInverseKinematics(written, goal, 0, -Eigen::Vector3d::UnitZ());
    const auto usable = [](const InverseKinematics& of) {
      return std::ranges::count(of.branches, BranchStatus::kConverged, &Branch::status);
    };
    EXPECT_EQ(one.status, other.status) << n << ": " << other.reason;
    EXPECT_EQ(usable(one) > 0, usable(other) > 0) << n;
    found += usable(one) > 0;
    for (const Branch& branch : other.branches) {
      if (branch.status != BranchStatus::kConverged) continue;
      EXPECT_LE((rigidFramesOf<double>(arm, branch.q).tip - goal.p_BT).norm(), 1e-9) << n;
    }
  }
  EXPECT_GE(found, 9);  // not all 12, because a random posture may be singular
}

}  // namespace
}  // namespace tubeplan::deflection
