#include "planner/collision/arm_clearance.hpp"

#include <gtest/gtest.h>

#include "planner/reach/compensation.hpp"
#include "planner/scene/separation.hpp"
#include "tests/planner/collision_world.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using testing::mockup;
using testing::randomPosture;
using testing::uniform;

/// Returns a weightless cantilever along x: one revolute row about z, gravity along -y, and a load at the tip.
Workcell cantilever(double length, double bending_stiffness, double load) {
  Workcell cell;
  deflection::Row<double> row;
  row.name = "bar";
  row.placement = deflection::DenavitHartenberg<double>{};
  row.joint.type = deflection::JointType::kRevolute;
  row.beam = deflection::Beam<double>{};
  row.beam->E = bending_stiffness;
  row.beam->I.z() = 1;
  cell.arm.rows = {row};
  cell.arm.p_LT = Vector3d(length, 0, 0);
  cell.arm.gravity_W = -Vector3d::UnitY();
  cell.load = load;
  cell.scene.links = {{"bar", true}};
  cell.scene.bodies = {{"bar", 0, "", testing::shape("capsule", {0, 0, 0, length, 0, 0, 0.01}), {}}};
  return cell;
}

TEST(BodyFrames, ALoadedCantileverLiesAlongItsChordWithTheBowOfTheClosedForm) {
  const double length = 1.2, stiffness = 5000, load = 20;
  const Workcell cell = cantilever(length, stiffness, load);
  double bow = 0;
  const auto frames = bodyFrames(cell, VectorXd::Zero(1), &bow);
  const double unit = load * length * length * length / stiffness;
  const Vector3d end = frames[0] * Vector3d(length, 0, 0);
  // End displacement F L^3 / (3 E I); the bent axis deviates by at most 0.0642 F L^3 / (E I) from its chord.
  EXPECT_NEAR(end.y() / end.x(), -unit / 3 / length, 0.02 * unit / 3 / length);
  EXPECT_GE(bow, 0.06415 * unit);
  EXPECT_LE(bow, 0.08 * unit);
}

TEST(BodyFrames, SeveralSegmentsPromiseNoLessBowThanThereIs) {
  Workcell cell = cantilever(1.2, 5000, 20);
  cell.arm.rows[0].beam->segments = 6;
  double bow = 0;
  EXPECT_FALSE(bodyFrames(cell, VectorXd::Zero(1), &bow).empty());
  const double unit = 20 * 1.2 * 1.2 * 1.2 / 5000;
  EXPECT_GE(bow, 0.06415 * unit);
  EXPECT_LE(bow, 0.15 * unit);
}

TEST(BodyFrames, ARigidArmHasItsKinematicFramesAndNoBow) {
  const Workcell cell = testing::rigid(mockup());
  std::mt19937_64 generator(1);
  for (int round = 0; round < 50; ++round) {
    const VectorXd q = randomPosture(cell.arm, generator);
    double bow = 1;
    const auto frames = bodyFrames(cell, q, &bow);
    const auto shape =
        deflection::solveFlexibleKinematics(cell.arm, {q, 0, deflection::gravityInBase(cell.arm, cell.X_WB)});
    const auto expected = deflection::rowFramesInWorld(shape, cell.X_WB);
    ASSERT_EQ(frames.size(), expected.size());
    for (std::size_t k = 0; k < frames.size(); ++k) EXPECT_LT((frames[k].matrix() - expected[k].matrix()).norm(), 1e-9);
    EXPECT_EQ(bow, 0);
  }
}

TEST(BodyFrames, MembersRunFromTheirFrameToTheNextOnTheDeflectedShape) {
  const Workcell cell = mockup();
  std::mt19937_64 generator(2);
  for (int round = 0; round < 50; ++round) {
    const VectorXd q = randomPosture(cell.arm, generator);
    double bow = 0;
    const auto frames = bodyFrames(cell, q, &bow);
    EXPECT_GT(bow, 0);
    EXPECT_LT(bow, 0.1 * kInch);
    // The far end of the bent latch-link, 26.406 in along its x axis, is at the origin of the forearm's frame.
    const Vector3d end = frames[3] * Vector3d(26.406 * kInch, 0, 0);
    EXPECT_LT((end - frames[4].translation()).norm(), 1e-3 * kInch);
    const Vector3d tip = frames.back() * cell.arm.p_LT;
    EXPECT_LT((tip - testing::deflectedTip(cell, q)).norm(), 1e-9);
  }
}

/// Heights of the lowest and the highest point of the arm's bodies [m].
struct Span {
  double lowest, highest;
};
Span heightsOf(const Workcell& cell, const VectorXd& q) {
  const auto frames = bodyFrames(cell, q, nullptr);
  Span span{1e9, -1e9};
  for (const auto& body : cell.scene.bodies) {
    if (body.link == "base-link") continue;
    const auto& capsule = static_cast<const Solid&>(*body.shape).around();
    const auto& X = frames[static_cast<std::size_t>(body.frame_index)];
    for (const Vector3d& end : {Vector3d(X * capsule.from), Vector3d(X * capsule.to)}) {
      span.lowest = std::min(span.lowest, end.z() - capsule.radius);
      span.highest = std::max(span.highest, end.z() + capsule.radius);
    }
  }
  return span;
}

TEST(ArmClearance, ItIsTheDeflectedShapeThatIsChecked) {
  // An arm stretched out horizontally sags. Only the deflected shape is too close to a shelf placed just below the
  // rigid shape, and only the rigid shape is too close to a ceiling just above it.
  const Workcell bent = testing::alone(mockup()), rigid = testing::rigid(bent);
  const VectorXd q = Eigen::Vector4d(0.3, 0, 0, 0);
  const Span bent_span = heightsOf(bent, q), rigid_span = heightsOf(rigid, q);
  const double sag = rigid_span.lowest - bent_span.lowest;
  ASSERT_GT(sag, 0.5 * kInch);
  const double clearance = bent.scene.clearance;
  const auto marginUnder = [&](const Workcell& cell, double height, double normal) {
    const Workcell among = testing::withObstacle(
        cell, {"level", testing::shape("keep_side", {0, 0, height, 0, 0, normal}), {"base-link"}});
    return ArmClearance(among).at(q, ContactRule::kTravel);
  };
  const double shelf = rigid_span.lowest - clearance - sag / 2;
  EXPECT_GT(marginUnder(rigid, shelf, 1).margin, 0.2 * sag);
  EXPECT_LT(marginUnder(bent, shelf, 1).margin, -0.2 * sag);
  EXPECT_EQ(marginUnder(bent, shelf, 1).other, "level");
  const double drop = rigid_span.highest - bent_span.highest;
  ASSERT_GT(drop, 0.02 * kInch);
  const double ceiling = rigid_span.highest + clearance - drop / 4;
  EXPECT_LT(marginUnder(rigid, ceiling, -1).margin, 0);
  EXPECT_GT(marginUnder(bent, ceiling, -1).margin, 0);
}

TEST(ArmClearance, TheBowOfABentMemberIsTakenOff) {
  const Workcell cell = mockup();
  const CollisionWorld world(cell.scene);
  const ArmClearance clearance(cell);
  std::mt19937_64 generator(3);
  for (int round = 0; round < 50; ++round) {
    const VectorXd q = randomPosture(cell.arm, generator);
    double bow = 0;
    const auto frames = bodyFrames(cell, q, &bow);
    const Clearance found = clearance.at(q, ContactRule::kApproach), straight = world.closest(frames);
    // The two methods add lengths of metres in different order, so the results agree only to rounding.
    EXPECT_NEAR(found.margin, straight.margin - bow, 1e-14);
    EXPECT_NEAR(found.distance, straight.distance - bow, 1e-14);
    EXPECT_DOUBLE_EQ(clearance.withSpare(q, ContactRule::kApproach, 0.003).margin, found.margin - 0.003);
  }
}

class UnderAHole : public ::testing::Test {
 protected:
  const Workcell cell = mockup();
  /// Returns a posture with the tip half an inch inside the hole R10C40.
  VectorXd inTheHole() const {
    CompensationOptions options;
    options.with_approach = false;
    const Vector3d inside =
        testing::holeOf(cell, testing::tubesOf(cell, "R10C40").front()) + Vector3d(0, 0, 0.5 * kInch);
    return compensate(cell, inside, options).front().q;
  }
};

TEST_F(UnderAHole, TheTipMayEnterOnApproachAndNotOnTravel) {
  const ArmClearance clearance(cell);
  const VectorXd q = inTheHole();
  EXPECT_GT(clearance.at(q, ContactRule::kApproach).margin, 0);
  const Clearance travelling = clearance.at(q, ContactRule::kTravel);
  EXPECT_LT(travelling.distance, 0);
  EXPECT_EQ(travelling.body, "tool-tip");
  EXPECT_EQ(travelling.other, "tubesheet");
}

TEST_F(UnderAHole, ALeaveThatTheToolsOwnBodyStatesEndsOnTravelToo) {
  Workcell turned = cell;
  for (auto& obstacle : turned.scene.obstacles) std::erase(obstacle.allow, "tool-tip");
  for (auto& body : turned.scene.bodies)
    if (body.name == "tool-tip") body.allow = {"tubesheet"};
  const ArmClearance in_turned(turned), in_cell(cell);
  const VectorXd q = inTheHole();
  for (const auto rule : {ContactRule::kTravel, ContactRule::kApproach})
    EXPECT_EQ(in_turned.at(q, rule).margin, in_cell.at(q, rule).margin);
}

TEST_F(UnderAHole, WhatTheRestOfTheArmMayTouchItMayAlwaysTouch) {
  const ArmClearance clearance(cell);
  std::mt19937_64 generator(4);
  for (int round = 0; round < 200; ++round) {
    const VectorXd q = randomPosture(cell.arm, generator);
    const Clearance travelling = clearance.at(q, ContactRule::kTravel),
                    approaching = clearance.at(q, ContactRule::kApproach);
    EXPECT_LE(travelling.margin, approaching.margin);
    if (travelling.body != "tool-tip") {
      EXPECT_EQ(travelling.margin, approaching.margin);
    }
  }
}

TEST(ArmClearance, ToolsOwnClearanceIsUntouchedByTheRules) {
  const Workcell cell = mockup();
  const ArmClearance clearance(cell);
  const VectorXd q = Eigen::Vector4d(0, 1.2, -1.4, 0);
  EXPECT_EQ(&clearance.cell(), &cell);
  EXPECT_EQ(clearance.travel().reach_per_joint.size(), 4);
  EXPECT_GT(clearance.travel().reach_per_joint[0], clearance.travel().reach_per_joint[3]);
  EXPECT_FALSE(std::isnan(clearance.at(q, ContactRule::kTravel).margin));
}

TEST(ArmClearance, AShapeThatDoesNotSettleIsNotFree) {
  Workcell cell = mockup();
  cell.arm.rows.back().joint_stiffness.z() = 1e-3;
  const Clearance clearance = ArmClearance(cell).at(Eigen::Vector4d(0, 1.2, -1.4, 0), ContactRule::kTravel);
  EXPECT_TRUE(std::isnan(clearance.margin));
  EXPECT_EQ(clearance.other, "the deflected shape does not converge");
}

class TravelOfSeed : public ::testing::TestWithParam<int> {};

TEST_P(TravelOfSeed, NoBodyPointMovesFurtherThanTheBound) {
  const Workcell cell = mockup();
  const ArmClearance clearance(cell);
  std::mt19937_64 generator(static_cast<std::uint64_t>(GetParam()));
  double most = 0;
  for (int round = 0; round < 1000; ++round) {
    const VectorXd q0 = randomPosture(cell.arm, generator);
    VectorXd q1 = q0;
    const double size = std::pow(10.0, uniform(generator, -4, -0.5));
    // A single joint moves in most rounds: with several, the bounds of the other joints would hide an error.
    const int only = static_cast<int>(uniform(generator, -2, 4));
    for (int j = 0; j < q1.size(); ++j)
      if (only < 0 || only == j) q1[j] += uniform(generator, -size, size);
    const auto from = bodyFrames(cell, q0, nullptr), to = bodyFrames(cell, q1, nullptr);
    const double bound = clearance.travel()(q0, q1);
    for (const auto& body : cell.scene.bodies) {
      const auto& capsule = static_cast<const Solid&>(*body.shape).around();
      const auto frame = static_cast<std::size_t>(body.frame_index);
      for (const Vector3d& end : {capsule.from, capsule.to})
        most = std::max(most, (to[frame] * end - from[frame] * end).norm() / bound);
    }
    const double before = clearance.at(q0, ContactRule::kTravel).distance,
                 after = clearance.at(q1, ContactRule::kTravel).distance;
    if (before > 0 && after > 0) {
      EXPECT_LE(std::abs(before - after), bound + 1e-8);
    }
  }
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TravelOfSeed, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace tubeplan::planner
