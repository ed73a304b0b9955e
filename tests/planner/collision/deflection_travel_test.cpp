#include "planner/collision/deflection_travel.hpp"

#include <gtest/gtest.h>

#include "deflection/effects/effect.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "planner/scene/separation.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;

/// Returns the ends of all bodies in a posture [m]; `bow` receives the largest bow if it is not null.
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

/// Expects that no point of a body moves by more than the bound, changes of the bow included, in large and small steps.
void expectBounded(const Workcell& cell, std::uint64_t seed) {
  const ArmTravel travel = armTravelOf(cell, bodyReachOf(cell.scene));
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

/// The bound also holds if a linkage turns the forearm with the two joints before it, faster than these joints turn.
TEST(DeflectionTravel, BoundsAnArmWhoseForearmALinkageTurns) {
  for (const bool is_rigid : {true, false}) {
    Workcell cell = is_rigid ? testing::rigid(testing::mockup()) : testing::mockup();
    auto& joint = cell.arm.rows[4].joint;
    joint.type = deflection::JointType::kPassive;
    joint.follows = {{2, 2.5}, {3, -3}};
    expectBounded(cell, 3);
  }
}

/// The bound holds for an arm on a vertical or horizontal prismatic joint, whose bar bends under the arm, the load and
/// its own weight.
TEST(DeflectionTravel, BoundsAnArmWithASlide) {
  for (const bool is_level : {false, true})
    for (const double load : {0., 200.}) {
      Workcell cell = testing::mockup("column.yaml");
      cell.load = load;
      for (auto& row : cell.arm.rows) row.beam->I /= 3;
      if (is_level) cell.X_WB.linear() = Eigen::AngleAxisd(1.5, Vector3d(1, 2, 0).normalized()).toRotationMatrix();
      expectBounded(cell, 4);
    }
}

/// With only one compliant element at a time, the bound holds for finite differences of the deflected shape.
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
      const auto travel = deflectionTravelOf(cell, bodyReachOf(cell.scene));
      ASSERT_TRUE(travel.is_proved) << travel.reason;
      std::mt19937_64 random(row);
      for (int k = 0; k < 50; ++k) {
        const VectorXd q = testing::randomPosture(cell.arm, random);
        for (Eigen::Index j = 0; j < q.size(); ++j) {
          VectorXd moved = q;
          moved[j] += 1e-5;
          // Displacement due to deflection: points of the bent arm minus points of the rigid arm.
          const auto bent0 = pointsAt(cell, q, nullptr), bent1 = pointsAt(cell, moved, nullptr);
          const auto rigid0 = pointsAt(rigid, q, nullptr), rigid1 = pointsAt(rigid, moved, nullptr);
          for (std::size_t p = 0; p < bent0.size(); ++p) {
            const double sag = (bent0[p] - rigid0[p]).norm();
            const double extra = ((bent1[p] - bent0[p]) - (rigid1[p] - rigid0[p])).norm();
            // The joint also turns the sag. This is motion of the frozen bent shape, not a change of the deflection, so
            // `sag` is added to the bound.
            EXPECT_LE(extra, 1e-5 * (travel.per_joint[j] + sag) + 1e-11);
          }
        }
      }
    }
}

/// A horizontal prismatic joint with a compliant bar or bearing moves points by no more than the bound, plus the travel
/// along the end of the bent bar.
TEST(DeflectionTravel, BoundsWhatASlideGains) {
  for (const bool bar_bends : {true, false}) {
    Workcell cell = testing::rigid(testing::mockup("column.yaml"));
    cell.X_WB.linear() = Eigen::AngleAxisd(1.5, Vector3d::UnitX()).toRotationMatrix();
    auto& row = cell.arm.rows[0];
    if (bar_bends)
      row.beam = testing::mockup("column.yaml").arm.rows[0].beam;
    else
      row.joint_stiffness.setConstant(3e4);
    const auto travel = deflectionTravelOf(cell, bodyReachOf(cell.scene));
    ASSERT_TRUE(travel.is_proved) << travel.reason;
    std::mt19937_64 random(1);
    double most = 0;
    for (int k = 0; k < 300; ++k) {
      const VectorXd q = testing::randomPosture(cell.arm, random), moved = q + 1e-5 * VectorXd::Unit(q.size(), 0);
      const auto before = pointsAt(cell, q, nullptr), after = pointsAt(cell, moved, nullptr);
      const Vector3d way = 1e-5 * bodyFrames(cell, q, nullptr)[0].linear().col(2);
      for (std::size_t p = 0; p < before.size(); ++p) most = std::max(most, (after[p] - before[p] - way).norm() / 1e-5);
    }
    EXPECT_LE(most, travel.per_joint[0]);
    EXPECT_GE(most, 0.3 * travel.per_joint[0]) << "the bound is far from what happens";
  }
}

/// Two joints and a beam of length `beam`, all compliant. A rotation gained by one element causes rotations of the
/// others, and so on; the sum of this geometric series is the inverse of the identity minus the matrix of one round.
struct ThreeElements {
  Vector3d compliance, moment, weight, reach;
  double beam = 0;

  [[nodiscard]] double travelBy(const Vector3d& first) const {
    const Vector3d bending = compliance.cwiseProduct(moment), displacement(0, 0, beam * (1 + 2 * bending[2]));
    Eigen::Matrix3d round;
    for (int e = 0; e < 3; ++e)
      for (int other = 0; other < 3; ++other)
        round(e, other) = compliance[e] * (other < e ? moment[e] : moment[other] + weight[other] * displacement[other]);
    const Vector3d arms = (Vector3d::Ones() + 2 * bending).cwiseProduct(reach) + 0.3 * displacement;
    return arms.dot((Eigen::Matrix3d::Identity() - round).inverse() * first);
  }
};

/// Returns a cell whose arm has a revolute joint in a compliant bearing, then joint `outer` in a compliant bearing with
/// a beam that has the compliances `bends` about its axes.
Workcell twoRows(const deflection::Joint<double>& outer, const Vector3d& bends) {
  deflection::Row<double> first, second;
  first.placement = deflection::Origin<double>{};
  first.joint.type = deflection::JointType::kRevolute;
  first.joint_stiffness = Vector3d::Constant(1500);
  first.weight.end = 20;
  second.placement = deflection::DenavitHartenberg<double>{0, 0.5, 0, 0};
  second.joint = outer;
  second.joint_stiffness = Vector3d::Constant(700);
  second.beam = deflection::Beam<double>{};
  second.beam->E = 720;
  second.beam->I = bends.cwiseInverse();
  second.weight.distributed = 10;
  Workcell cell = testing::mockup();
  cell.arm = {};
  cell.arm.rows = {first, second};
  cell.scene.bodies.clear();
  cell.arm.p_LT = Vector3d(0.8, 0, 0);
  cell.load = 30;
  return cell;
}

TEST(DeflectionTravel, CountsWhatElementsTurnInEachOtherToTheEnd) {
  Workcell cell = twoRows({.name = "turn", .type = deflection::JointType::kRevolute}, {0, 1, 1});
  const auto travel = deflectionTravelOf(cell, {0.2, 1});
  ASSERT_TRUE(travel.is_proved) << travel.reason;

  const double stretch = 1.01, a = 0.5 * stretch, b = 0.8 * stretch;
  const double W1 = 30 + 10 * b, M1 = 30 * b + 10 * b * b / 2, M0 = M1 + (W1 + 20) * a;
  const Vector3d compliance(1. / 1500, 1. / 700, 0.8 / 720), moment(M0, M1, M1), weight(W1 + 20, W1, W1);
  const ThreeElements elements{compliance, moment, weight, {1 + a, 1, 1}, b};
  ASSERT_EQ(travel.per_joint.size(), 2);
  EXPECT_NEAR(travel.per_joint[0], elements.travelBy(compliance.cwiseProduct(moment)), 1e-10);
  EXPECT_NEAR(travel.per_joint[1], elements.travelBy(compliance * M1), 1e-10);
  EXPECT_EQ(travel.stretch, stretch);

  // With 13 such joints at one place the series diverges, so no bound is proved, although each joint turns by less than
  // its limit.
  auto upper = cell.arm.rows[0], fore = cell.arm.rows[1];
  upper.joint_stiffness.setConstant(1000);
  upper.weight.end = 0;
  fore.joint_stiffness.setConstant(1000);
  fore.placement = deflection::Origin<double>{};
  fore.beam.reset();
  fore.weight.distributed = 0;
  cell.arm.rows = {upper};
  for (int k = 0; k < 13; ++k) cell.arm.rows.push_back(fore);
  cell.load = 100;
  const auto without = deflectionTravelOf(cell, std::vector<double>(14, 1));
  EXPECT_FALSE(without.is_proved);
  EXPECT_NE(without.reason.find("compliant"), std::string::npos) << without.reason;
}

/// The bound for a prismatic joint in a compliant bearing, with a bending bar and behind a revolute joint, equals the
/// closed form.
TEST(DeflectionTravel, CountsWhatASlideAddsToEachElement) {
  Workcell cell =
      twoRows({.name = "slide", .type = deflection::JointType::kPrismatic, .offset = 0.1, .lower = -0.3, .upper = 0.6},
              {1, 1, 0});
  cell.arm.rows[1].weight.end = 5;
  const auto travel = deflectionTravelOf(cell, {0.2, 1});
  ASSERT_TRUE(travel.is_proved) << travel.reason;

  const double stretch = 1.01, a = 0.5 * stretch, bar = 0.7 * stretch, tip = 0.8 * stretch;
  const double W1 = 30 + 5 + 10 * bar, M1 = 30 * (bar + tip) + 5 * bar + 10 * bar * bar / 2, M0 = M1 + (W1 + 20) * a;
  const Vector3d compliance(1. / 1500, 1. / 700, 0.7 / 720), moment(M0, M1, M1), weight(W1 + 20, W1, W1);
  const Vector3d reach(bar + 1 + a, bar + 1, bar + 1);
  const Vector3d first(compliance[0] * (W1 + 10 * reach[0]), compliance[1] * (W1 + 10 * reach[1]), M1 / 720);
  const ThreeElements elements{compliance, moment, weight, reach, bar};
  ASSERT_EQ(travel.per_joint.size(), 2);
  EXPECT_NEAR(travel.per_joint[1], elements.travelBy(first), 1e-10);
}

/// The jump is the sum over all joints of the play times the reach of everything beyond the joint.
TEST(DeflectionTravel, AGapLetsEverythingBeyondItJump) {
  Workcell cell = testing::mockup();
  const std::vector<double> thin(cell.arm.rows.size(), 0);
  EXPECT_EQ(gapJumpOf(cell, thin), 0);
  for (const auto& [at, gap] : {std::pair{"tool.z", 0.002}, {"forearm.z", 0.003}}) {
    auto effect = deflection::makeEffect(cell.arm, "backlash", at).effect;
    effect.values = {gap};
    cell.arm.effects.push_back(effect);
  }
  const double tool = std::hypot(16.2493, 7.8471) * kInch, forearm = 19.4 * kInch;
  EXPECT_NEAR(gapJumpOf(cell, thin), 0.002 * tool + 0.003 * (forearm + tool), 1e-9);
  // A body that extends beyond the rows counts with its full extent.
  std::vector<double> thick = thin;
  thick[4] = 2;
  EXPECT_NEAR(gapJumpOf(cell, thick), 0.002 * tool + 0.003 * 2, 1e-9);
  const auto travel = deflectionTravelOf(cell, thin);
  EXPECT_FALSE(travel.is_proved);
  EXPECT_EQ(travel.jump, gapJumpOf(cell, thin));
  // A prismatic joint adds its largest extension to the reach beyond its own row and the rows before it.
  auto& slide = cell.arm.rows[5].joint;
  slide.type = deflection::JointType::kPrismatic;
  slide.offset = 0.1;
  slide.lower = -1.7;
  slide.upper = 1.2;
  EXPECT_NEAR(gapJumpOf(cell, thick), 0.002 * (1.6 + tool) + 0.003 * (1.6 + forearm + tool), 1e-9);
}

TEST(DeflectionTravel, ARigidArmAddsNothing) {
  const Workcell cell = testing::rigid(testing::mockup());
  const auto travel = deflectionTravelOf(cell, bodyReachOf(cell.scene));
  EXPECT_TRUE(travel.is_proved);
  EXPECT_TRUE(travel.per_joint.isZero(0));
}

TEST(DeflectionTravel, TellsWhereItProvesNothing) {
  Workcell cell = testing::mockup();
  cell.load = 1e5;
  EXPECT_FALSE(deflectionTravelOf(cell, bodyReachOf(cell.scene)).is_proved);
  cell = testing::mockup();
  auto& slide = cell.arm.rows.back().joint;
  slide.type = deflection::JointType::kPrismatic;
  slide.upper = std::numeric_limits<double>::infinity();
  const auto travel = deflectionTravelOf(cell, bodyReachOf(cell.scene));
  EXPECT_FALSE(travel.is_proved);
  EXPECT_NE(travel.reason.find("slide without limits"), std::string::npos) << travel.reason;
}

}  // namespace
}  // namespace tubeplan::planner
