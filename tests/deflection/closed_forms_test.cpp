// The deflection of a single flexible member must agree with closed forms of the cantilever (Calkins 1994, equations
// 2.9 to 2.17, and 2.8 with 3 instead of 2).
#include <gtest/gtest.h>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {
namespace {

constexpr double kBeam = 0.8, kEI = 5e4, kGJ = 2e4;

/// Returns a turntable that carries a beam along x; gravity may have any direction.
Arm cantilever(double distributed = 0, double lump = 0,
               const Eigen::Vector3d& lump_beyond_tip = Eigen::Vector3d::Zero()) {
  Arm arm;
  arm.name = "cantilever";
  Row<double> row;
  row.name = "boom";
  row.placement = DenavitHartenberg<double>{};
  row.joint.name = "turn";
  row.joint.type = JointType::kRevolute;
  row.beam = Beam<double>{};
  row.beam->E = 2e11;
  row.beam->I[2] = row.beam->I[1] = kEI / 2e11;
  row.beam->G = 8e10;
  row.beam->J = kGJ / 8e10;
  row.weight.distributed = distributed;
  arm.rows = {row};
  Row<double> hand;
  hand.name = "hand";
  hand.placement = DenavitHartenberg<double>{0, kBeam, 0, 0};
  if (lump > 0) hand.weight.lumps = {{lump, lump_beyond_tip}};
  arm.rows.push_back(hand);
  return arm;
}

FlexibleKinematics solve(const Arm& arm, double load, const Eigen::Vector3d& gravity = -Eigen::Vector3d::UnitY()) {
  auto shape = solveFlexibleKinematics(arm, {Eigen::VectorXd::Zero(1), load, gravity}, {1e-14, 100});
  EXPECT_EQ(shape.status, KinematicsStatus::kConverged) << shape.reason;
  return shape;
}

double slopeAboutZ(const FlexibleKinematics& shape) { return std::atan2(shape.X_BD.R(1, 0), shape.X_BD.R(0, 0)); }

/// A joint that is compliant only about its axis must rotate to the exact equilibrium angle, below and above 0.1 rad,
/// the limit of the series for sine and cosine.
TEST(ClosedForms, AJointsTurnIsExactToRounding) {
  for (const double angle : {0.02, 0.0999, 0.1001, 0.3}) {
    Arm arm;
    Row<double> link;
    link.name = "link";
    link.placement = DenavitHartenberg<double>{};
    link.joint = {.name = "turn", .type = JointType::kRevolute};
    link.joint_stiffness.z() = 1e4;
    arm.rows = {link};
    arm.p_LT = {1, 0, 0};
    Posture posture{Eigen::VectorXd::Zero(1), 0, -Eigen::Vector3d::UnitY()};
    posture.wrench.emplace();  // kernels do not support wrenches: the general sweeps solve the arm
    posture.wrench->force_B = {0, -1e4 * angle / std::cos(angle), 0};  // equilibrium: k angle = F L cos(angle)
    const auto shape = solveFlexibleKinematics(arm, posture, {1e-15, 100});
    ASSERT_EQ(shape.status, KinematicsStatus::kConverged) << angle;
    EXPECT_NEAR(shape.X_BD.R(1, 0), -std::sin(angle), 2e-15) << angle;
    EXPECT_NEAR(shape.X_BD.R(0, 0), std::cos(angle), 2e-15) << angle;
    EXPECT_NEAR(shape.X_BD.p.norm(), 1, 2e-15) << angle;
  }
}

TEST(ClosedForms, EndForce) {
  const double F = 0.5;
  const auto shape = solve(cantilever(), F);
  EXPECT_NEAR(shape.X_BD.p.y(), -F * std::pow(kBeam, 3) / (3 * kEI), 1e-6 * F * std::pow(kBeam, 3) / kEI);
  EXPECT_NEAR(slopeAboutZ(shape), -F * kBeam * kBeam / (2 * kEI), 1e-6 * F / kEI);
}

TEST(ClosedForms, DistributedWeight) {
  const double w = 0.7;
  const auto shape = solve(cantilever(w), 0);
  EXPECT_NEAR(shape.X_BD.p.y(), -w * std::pow(kBeam, 4) / (8 * kEI), 1e-6 * w / kEI);
  EXPECT_NEAR(slopeAboutZ(shape), -w * std::pow(kBeam, 3) / (6 * kEI), 1e-6 * w / kEI);
}

TEST(ClosedForms, EndMomentFromALumpBeyondTheTip) {
  const double W = 0.4, beyond = 0.3, M = W * beyond;
  const auto shape = solve(cantilever(0, W, {beyond, 0, 0}), 0);
  EXPECT_NEAR(shape.X_BD.p.y(), -W * std::pow(kBeam, 3) / (3 * kEI) - M * kBeam * kBeam / (2 * kEI), 1e-6 * W / kEI);
  EXPECT_NEAR(slopeAboutZ(shape), -W * kBeam * kBeam / (2 * kEI) - M * kBeam / kEI, 1e-6 * W / kEI);
}

TEST(ClosedForms, ALumpAlongTheMemberBendsIt) {
  for (double share : {0.25, 0.5, 1.0}) {
    Arm arm = cantilever();
    const double W = 0.4, a = share * kBeam;
    arm.rows[0].weight.lumps = {{W, {a, 0, 0}}};
    const auto shape = solve(arm, 0);
    EXPECT_NEAR(shape.X_BD.p.y(), -W * a * a / (6 * kEI) * (3 * kBeam - a), 1e-6 * W / kEI) << share;
  }
}

TEST(ClosedForms, ALumpAtTheEndIsAnEndWeight) {
  Arm with_end = cantilever(), with_lump = cantilever();
  with_end.rows[0].weight.end = 150;
  with_lump.rows[0].weight.lumps = {{150, {kBeam, 0, 0}}};
  EXPECT_LE((solve(with_end, 20).X_BD.p - solve(with_lump, 20).X_BD.p).norm(), 1e-13);
}

TEST(ClosedForms, TorsionFromALumpAside) {
  const double W = 0.4, aside = 0.25;
  const auto shape = solve(cantilever(0, W, {0, 0, aside}), 0);
  const double twist = std::atan2(shape.X_BD.R(2, 1), shape.X_BD.R(2, 2));
  EXPECT_NEAR(twist, W * aside * kBeam / kGJ, 1e-6 * W / kGJ);
}

TEST(ClosedForms, BendingIsTheSameAboutYAndZ) {
  const auto down = solve(cantilever(0.7), 3, -Eigen::Vector3d::UnitY());
  const auto across = solve(cantilever(0.7), 3, -Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(down.X_BD.p.y(), across.X_BD.p.z(), 1e-15);
  EXPECT_NEAR(down.X_BD.p.x(), across.X_BD.p.x(), 1e-15);
}

TEST(ClosedForms, ForeshorteningOfAnEndForce) {
  // 3/5 delta^2 / L is the classical shortening of a cantilever under an end force.
  const double F = 200, delta = F * std::pow(kBeam, 3) / (3 * kEI);
  const auto shape = solve(cantilever(), F);
  EXPECT_NEAR(kBeam - shape.X_BD.p.x(), 0.6 * delta * delta / kBeam, 2e-3 * delta * delta);
}

TEST(ClosedForms, JointStiffness) {
  Arm arm = cantilever();
  arm.rows[0].beam.reset();
  arm.rows[0].joint_stiffness[2] = 3e4;
  const double F = 50;
  const auto shape = solve(arm, F);
  // Fixed point of theta = F L cos(theta) / K, with the moment evaluated on the rotated arm.
  double theta = 0;
  for (int k = 0; k < 50; ++k) theta = F * kBeam * std::cos(theta) / 3e4;
  EXPECT_NEAR(slopeAboutZ(shape), -theta, 1e-12);
}

TEST(ClosedForms, APrismaticRowBendsAsFarAsItIsDrawnOut) {
  Arm arm;
  arm.name = "mast";
  Row<double> slide;
  slide.name = "mast";
  slide.placement = DenavitHartenberg<double>{std::numbers::pi / 2, 0, 0, 0};
  slide.joint.name = "extend";
  slide.joint.type = JointType::kPrismatic;
  slide.beam = Beam<double>{};
  slide.beam->E = 2e11;
  slide.beam->I[0] = kEI / 2e11;
  arm.rows = {slide};
  for (double drawn : {0.0, 0.2, 0.5, 1.1}) {
    const double F = 0.5;
    const auto shape =
        solveFlexibleKinematics(arm, {Eigen::VectorXd::Constant(1, drawn), F, -Eigen::Vector3d::UnitZ()}, {1e-14, 100});
    ASSERT_EQ(shape.status, KinematicsStatus::kConverged);
    EXPECT_NEAR(shape.X_BD.p.z(), -F * std::pow(drawn, 3) / (3 * kEI), 1e-6 * F / kEI) << drawn;
  }
}

TEST(ClosedForms, AnArmTooSoftIsSaidSo) {
  Arm arm = cantilever();
  arm.rows[0].beam.reset();
  arm.rows[0].joint_stiffness[2] = 1;
  const auto shape = solveFlexibleKinematics(arm, {Eigen::VectorXd::Zero(1), 1000, -Eigen::Vector3d::UnitY()});
  EXPECT_EQ(shape.status, KinematicsStatus::kNotConverged);
  EXPECT_FALSE(shape.reason.empty());
}

}  // namespace
}  // namespace tubeplan::deflection
