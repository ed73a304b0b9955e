#include "planner/collision/deflection_travel.hpp"

#include <gtest/gtest.h>

#include "planner/collision/arm_clearance.hpp"
#include "planner/scene/separation.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;

std::vector<double> bodyReachOf(const Workcell& cell) { return CollisionWorld(cell.scene).bodyReach(); }

/// Ends of all bodies in a posture, with the bow taken as a point that moves too.
std::vector<Vector3d> pointsAt(const Workcell& cell, const VectorXd& q, double* bow) {
  const auto frames = bodyFrames(cell, q, bow);
  std::vector<Vector3d> points;
  for (const auto& body : cell.scene.bodies) {
    const Capsule around = transformed(frames[static_cast<std::size_t>(body.frame_index)],
                                       static_cast<const Solid&>(*body.shape).around());
    points.push_back(around.from);
    points.push_back(around.to);
  }
  return points;
}

/// Travel beyond what a rigid arm's bound allows never exceeds the bound, for steps great and small.
void expectBounded(const Workcell& cell, std::uint64_t seed) {
  const ArmTravel travel = armTravelOf(cell, bodyReachOf(cell));
  ASSERT_TRUE(travel.is_proved) << travel.reason;
  std::mt19937_64 random(seed);
  for (int k = 0; k < 300; ++k) {
    const VectorXd q0 = testing::randomPosture(cell.arm, random);
    const VectorXd q1 = q0 + std::pow(10., -1. - k % 4) * (testing::randomPosture(cell.arm, random) - q0);
    double bow0 = 0, bow1 = 0;
    const auto before = pointsAt(cell, q0, &bow0), after = pointsAt(cell, q1, &bow1);
    for (std::size_t p = 0; p < before.size(); ++p)
      EXPECT_LE((after[p] - before[p]).norm() + std::abs(bow1 - bow0), travel.bound(q0, q1));
  }
}

TEST(DeflectionTravel, BoundsTheMockupsArmUnderAnyLoad) {
  for (const double load : {0., 100., 400.}) {
    Workcell cell = testing::mockup();
    cell.load = load;
    expectBounded(cell, 1);
  }
}

TEST(DeflectionTravel, BoundsArmsTenTimesAsSoft) {
  Workcell cell = testing::mockup();
  for (auto& row : cell.arm.rows) {
    row.joint_stiffness /= 2;
    if (row.beam) row.beam->I /= 2;
  }
  expectBounded(cell, 2);
}

/// One element at a time is the only one that gives: its travel is held against differences of the deflected shape.
TEST(DeflectionTravel, BoundsEachElementsOwnPart) {
  const Workcell nominal = testing::mockup();
  const Workcell rigid = testing::rigid(nominal);
  for (std::size_t row = 0; row < nominal.arm.rows.size(); ++row)
    for (const bool joint : {true, false}) {
      Workcell cell = rigid;
      if (joint)
        cell.arm.rows[row].joint_stiffness = nominal.arm.rows[row].joint_stiffness;
      else
        cell.arm.rows[row].beam = nominal.arm.rows[row].beam;
      const auto travel = deflectionTravelOf(cell, bodyReachOf(cell));
      ASSERT_TRUE(travel.is_proved) << travel.reason;
      std::mt19937_64 random(row);
      for (int k = 0; k < 50; ++k) {
        const VectorXd q = testing::randomPosture(cell.arm, random);
        for (Eigen::Index j = 0; j < q.size(); ++j) {
          VectorXd moved = q;
          moved[j] += 1e-5;
          // Points of the bent arm less those of the rigid one: what deflection adds.
          const auto bent0 = pointsAt(cell, q, nullptr), bent1 = pointsAt(cell, moved, nullptr);
          const auto rigid0 = pointsAt(rigid, q, nullptr), rigid1 = pointsAt(rigid, moved, nullptr);
          for (std::size_t p = 0; p < bent0.size(); ++p) {
            const double sag = (bent0[p] - rigid0[p]).norm();
            const double extra = ((bent1[p] - bent0[p]) - (rigid1[p] - rigid0[p])).norm();
            // The joint's own turn moves the sag along with the arm: that belongs to the frozen bent shape.
            EXPECT_LE(extra, 1e-5 * (travel.per_joint[j] + sag) + 1e-11);
          }
        }
      }
    }
}

TEST(DeflectionTravel, ARigidArmAddsNothing) {
  const Workcell cell = testing::rigid(testing::mockup());
  const auto travel = deflectionTravelOf(cell, bodyReachOf(cell));
  EXPECT_TRUE(travel.is_proved);
  EXPECT_TRUE(travel.per_joint.isZero(0));
}

TEST(DeflectionTravel, TellsWhereItProvesNothing) {
  Workcell cell = testing::mockup();
  cell.load = 1e5;
  EXPECT_FALSE(deflectionTravelOf(cell, bodyReachOf(cell)).is_proved);
  cell = testing::mockup();
  cell.arm.rows.back().joint.type = deflection::JointType::kPrismatic;
  const auto travel = deflectionTravelOf(cell, bodyReachOf(cell));
  EXPECT_FALSE(travel.is_proved);
  EXPECT_NE(travel.reason.find("slid"), std::string::npos);
}

}  // namespace
}  // namespace tubeplan::planner
