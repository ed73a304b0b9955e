// The checker's own statics: closed forms, convergence, and the shipped arms compared with the flexible kinematics.
#include "planner/verification/segmented_statics.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "app/formats/cell/cell_reader.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::planner {
namespace {

using deflection::Arm, deflection::Posture;
using Eigen::Vector3d, Eigen::VectorXd;

/// Returns a cantilever 2 m long along x with its z axis horizontal.
Arm cantilever(double E, double I) {
  Arm arm;
  auto& row = arm.rows.emplace_back();
  row.name = "rod";
  row.placement = deflection::Origin<double>{Vector3d::Zero(), {std::numbers::pi / 2, 0, 0}};
  row.joint = {.name = "shoulder", .type = deflection::JointType::kRevolute};
  row.beam = deflection::Beam<double>{};
  row.beam->E = E;
  row.beam->I.z() = I;
  arm.p_LT = {2, 0, 0};
  return arm;
}

SegmentedStatics solved(const Arm& arm, double load, int pieces = 32) {
  SegmentedStaticsOptions options;
  options.pieces = pieces;
  return solveSegmentedStatics(arm, {VectorXd::Zero(arm.jointCount()), load}, options);
}

TEST(SegmentedStatics, ACantileverSagsByTheClosedForm) {
  const Arm arm = cantilever(2e11, 1e-6);  // E I = 2e5 N m^2
  EXPECT_NEAR(solved(arm, 100, 512).p_BD.z(), -100. * 8 / (3 * 2e5), 1e-6 * 100 * 8 / (3 * 2e5) + 1e-8);
  Arm heavy = arm;
  heavy.rows[0].weight.distributed = 50;
  EXPECT_NEAR(solved(heavy, 0, 512).p_BD.z(), -50. * 16 / (8 * 2e5), 1e-8);
}

// Bisshopp and Drucker (1945): at P L^2 / EI = 1 the tip of a cantilever sags by 0.3017 L and moves 0.0564 L inwards.
TEST(SegmentedStatics, ALargeDeflectionIsTheElastica) {
  const auto shape = solved(cantilever(2e11, 1e-6), 2e5 / 4, 512);
  ASSERT_EQ(shape.status, SegmentedStaticsStatus::kConverged) << shape.reason;
  EXPECT_NEAR(-shape.p_BD.z() / 2, 0.30172, 2e-4);
  EXPECT_NEAR(1 - shape.p_BD.x() / 2, 0.05643, 2e-4);
}

TEST(SegmentedStatics, TheErrorFallsWithTheSquareOfThePieces) {
  const Arm arm = cantilever(2e11, 1e-6);
  const Vector3d fine = solved(arm, 5000, 1024).p_BD;
  const double coarse = (solved(arm, 5000, 8).p_BD - fine).norm(), twice = (solved(arm, 5000, 16).p_BD - fine).norm();
  EXPECT_NEAR(std::log2(coarse / twice), 2, 0.1);
}

VectorXd anyPosture(const Arm& arm, std::mt19937_64& random) {
  VectorXd q(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) {
    const auto& joint = arm.joint(k);
    const double low = std::max(joint.lower, -3.), high = std::min(joint.upper, 3.);
    q[k] = std::uniform_real_distribution<double>(low, high)(random);
  }
  return q;
}

/// Returns the largest distance between the tips computed by the two methods over random postures and loads [m].
double worstDifference(const Arm& arm, const Eigen::Isometry3d& X_WB, double largest_load, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  double worst = 0;
  for (int k = 0; k < 100; ++k) {
    const Posture posture{anyPosture(arm, random), std::uniform_real_distribution<double>(0, largest_load)(random),
                          deflection::gravityInBase(arm, X_WB)};
    const auto segmented = solveSegmentedStatics(arm, posture);
    EXPECT_EQ(segmented.status, SegmentedStaticsStatus::kConverged) << segmented.reason;
    const auto shape = deflection::solveFlexibleKinematics(arm, posture);
    worst = std::max(worst, (segmented.p_BD - shape.X_BD.p).norm());
  }
  return worst;
}

TEST(SegmentedStatics, AgreesWithTheFlexibleKinematicsOfEveryShippedArm) {
  for (const char* name : {"mockup", "bench", "tsm-cobra", "column", "puma", "iiwa"}) {
    const auto cell = app::readCell(fmt::format("{}/app/cells/{}.yaml", TUBEPLAN_SOURCE_DIR, name));
    EXPECT_LE(worstDifference(cell.arm, cell.X_WB, 130, 7), 2.5e-5) << name;  // 0.001 in
  }
}

TEST(SegmentedStatics, EffectsTakePart) {
  const auto cell = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml");
  const auto with = [&](const char* name, const char* at, std::vector<double> values) {
    Arm arm = cell.arm;
    auto effect = deflection::makeEffect(arm, name, at).effect;
    effect.values = std::move(values);
    arm.effects.push_back(effect);
    return arm;
  };
  for (const Arm& arm : {with("joint-compliance", "forearm.x", {1e-5}), with("hose-pull", "forearm", {20, 10, -15}),
                         with("tool-weight", "tool", {0.3}), with("joint-offset", "theta3", {0.01}),
                         with("stiffening", "tool.z", {0.6, 20}), with("lost-motion", "base-link.z", {1e-5, 20})})
    EXPECT_LE(worstDifference(arm, cell.X_WB, 100, 8), 2.5e-5) << deflection::textOf(arm, arm.effects.front());
  const Arm loose = with("backlash", "tool.z", {0.01});
  EXPECT_EQ(solveSegmentedStatics(loose, {VectorXd::Zero(4)}).status, SegmentedStaticsStatus::kNotCovered);
}

}  // namespace
}  // namespace tubeplan::planner
