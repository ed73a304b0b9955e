#include "deflection/row_placing.hpp"

#include <gtest/gtest.h>

#include "deflection/effects/effect.hpp"
#include "deflection/revolute_chain/revolute_chain.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "tests/planner/collision_world.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Index, Eigen::VectorXd;
using testing::mockup;
using testing::randomPosture;

/// Returns cells with the mock-up's arm, the same with divided members under a load, and a rigid arm; also two with
/// arms that no kernel supports, one with a joint compliant about two axes and one with an effect.
std::vector<Workcell> cells() {
  std::vector<Workcell> cells{mockup(), mockup(), testing::rigid(mockup()), mockup(), mockup()};
  for (auto& row : cells[1].arm.rows)
    if (row.beam) row.beam->segments = 3;
  cells[1].load = 150;
  cells[3].arm.rows[3].joint_stiffness = Eigen::Vector3d(3e4, deflection::kRigid, 2e4);
  cells[4].arm.effects.push_back({*deflection::findEffectKind("gravity-tilt"), {}, {0.01, -0.02}});
  return cells;
}

deflection::Side randomPostures(const Workcell& cell, Index count, std::mt19937_64& random) {
  deflection::Side q(cell.arm.jointCount(), count);
  for (Index k = 0; k < count; ++k) q.col(k) = randomPosture(cell.arm, random);
  return q;
}

TEST(RowPlacing, IsWhereBodyFramesAreWithTheSameBow) {
  std::mt19937_64 random(1);
  for (const Workcell& cell : cells()) {
    deflection::RowPlacing placing(cell.arm, cell.load, cell.X_WB);
    for (const Index count : {1, 2, 3, 5, 8, 17}) {
      const deflection::Side q = randomPostures(cell, count, random);
      for (Index first = 0; first < count; first += placing.lanes()) {
        const deflection::PlacedRows& placed = placing.place(q, first);
        ASSERT_EQ(placed.count, std::min<Index>(count - first, placing.lanes()));
        for (int lane = 0; lane < placed.count; ++lane) {
          double bow = 0;
          const auto frames = bodyFrames(cell, q.col(first + lane), &bow);
          ASSERT_TRUE(placed.is_converged[static_cast<std::size_t>(lane)]);
          EXPECT_NEAR(placed.bow[static_cast<std::size_t>(lane)], bow, 1e-12);
          for (std::size_t row = 0; row < frames.size(); ++row)
            EXPECT_LE((placed.X_WL(static_cast<int>(row), lane).matrix() - frames[row].matrix()).norm(), 1e-12);
        }
      }
    }
  }
}

TEST(RowPlacing, HasTheSameBitsAloneAndInAnyCompany) {
  std::mt19937_64 random(2);
  for (const Workcell& cell : cells()) {
    deflection::RowPlacing placing(cell.arm, cell.load, cell.X_WB), alone(cell.arm, cell.load, cell.X_WB);
    for (const Index count : {2, 3, 4, 7, 8}) {
      const deflection::Side q = randomPostures(cell, count, random);
      const deflection::PlacedRows& placed = placing.place(q, 0);
      for (int lane = 0; lane < placed.count; ++lane) {
        const deflection::PlacedRows& one = alone.place(VectorXd(q.col(lane)));
        EXPECT_EQ(placed.bow[static_cast<std::size_t>(lane)], one.bow[0]);
        for (int row = 0; row < static_cast<int>(cell.arm.rows.size()); ++row)
          EXPECT_EQ(placed.X_WL(row, lane).matrix(), one.X_WL(row, 0).matrix()) << count << " row " << row;
      }
    }
  }
}

TEST(RowPlacing, AKernelPlacesWhatItCan) {
  const std::vector<Workcell> all = cells();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const deflection::PreparedArm arm(all[k].arm);
    const auto* chain = arm.revoluteChain();
    EXPECT_EQ(chain && chain->rows().size() == all[k].arm.rows.size(), k < 3) << k;
  }
}

TEST(RowPlacing, SaysWhichShapesDoNotConverge) {
  Workcell cell = mockup();
  cell.arm.rows.back().joint_stiffness.z() = 1e-3;
  deflection::RowPlacing placing(cell.arm, cell.load, cell.X_WB);
  EXPECT_FALSE(placing.place(VectorXd(Eigen::Vector4d(0, 1.2, -1.4, 0))).is_converged[0]);
}

TEST(ArmClearance, ABatchHasTheMarginsOfItsPostures) {
  std::mt19937_64 random(3);
  for (const Workcell& cell : cells()) {
    const ArmClearance clearance(cell);
    const deflection::Side q = randomPostures(cell, 203, random);
    for (const ContactRule rule : {ContactRule::kTravel, ContactRule::kApproach}) {
      const MarginsSideBySide found = clearance.together(q, rule);
      ASSERT_EQ(found.margins.size(), 203u);
      Index tightest = 0;
      for (Index k = 0; k < q.cols(); ++k) {
        const double margin = clearance.at(VectorXd(q.col(k)), rule).margin;
        EXPECT_EQ(found.margins[static_cast<std::size_t>(k)], margin) << k;
        if (margin < found.margins[static_cast<std::size_t>(tightest)]) tightest = k;
      }
      EXPECT_EQ(found.tightest, static_cast<std::size_t>(tightest));
      const Clearance named = clearance.at(VectorXd(q.col(tightest)), rule);
      EXPECT_EQ(describe(found.clearance), describe(named));
      EXPECT_EQ(found.clearance.margin, named.margin);
      EXPECT_EQ(found.clearance.point_W, named.point_W);
    }
  }
}

TEST(ArmClearance, IsThatOfTheScalarKernelLessTheBow) {
  std::mt19937_64 random(4);
  for (const Workcell& cell : cells()) {
    const ArmClearance clearance(cell);
    const CollisionWorld world(cell.scene);
    for (int trial = 0; trial < 300; ++trial) {
      const VectorXd q = randomPosture(cell.arm, random);
      double bow = 0;
      const Clearance scalar = world.closest(bodyFrames(cell, q, &bow)),
                      found = clearance.at(q, ContactRule::kApproach);
      EXPECT_NEAR(found.margin, scalar.margin - bow - clearance.armTravel().jump, 1e-12);
      if (scalar.distance > 0) {
        EXPECT_EQ(found.body + found.other, scalar.body + scalar.other);
      }
    }
  }
}

}  // namespace
}  // namespace tubeplan::planner
