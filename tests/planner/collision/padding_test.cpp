#include "planner/collision/padding.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "planner/collision/arm_clearance.hpp"
#include "planner/scene/separation.hpp"
#include "planner/verification/lipschitz_distance.hpp"
#include "tests/planner/collision_world.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

Workcell withCovariance(unsigned seed, double size) {
  Workcell cell = testing::mockup();
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, 6, 6> root;
  for (double& value : root.reshaped()) value = size * normal(random);
  cell.base_covariance = root * root.transpose();
  return cell;
}

TEST(Padding, NothingWithoutUncertaintyOrSigmas) {
  Workcell cell = testing::mockup();
  cell.base_covariance.setZero();
  EXPECT_TRUE(BasePadding(cell, 3).isNone());
  cell.base_covariance.setIdentity();
  EXPECT_TRUE(BasePadding(cell, 0).isNone());
  EXPECT_EQ(BasePadding(cell, 0).of({Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero(), 1}, 0), 0);
}

TEST(Padding, AShiftAloneIsItsOwnDeviation) {
  Workcell cell = testing::mockup();
  cell.base_covariance.setZero();
  cell.base_covariance.diagonal().head<3>() << 1e-8, 4e-8, 1e-8;
  const BasePadding padding(cell, 3);
  const Capsule body{Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero(), 0.2};
  EXPECT_NEAR(padding.of(body, 0), 3 * 2e-4, 1e-12);
  EXPECT_NEAR(padding.along(Eigen::Vector3d::UnitZ(), body, 0), 3 * 1e-4, 1e-12);
  EXPECT_EQ(padding.slope(), 0);
}

TEST(Padding, TheArmsOwnDeviationAddsInSquares) {
  Workcell cell = testing::mockup();
  cell.base_covariance.setZero();
  cell.base_covariance.diagonal().head<3>() << 9e-8, 9e-8, 9e-8;
  cell.row_deviations.assign(cell.arm.rows.size(), 0);
  cell.row_deviations.back() = 4e-4;
  const BasePadding padding(cell, 2);
  const Capsule body{Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero(), 0.2};
  EXPECT_NEAR(padding.of(body, tipRow(cell.arm)), 2 * 5e-4, 1e-12);
  EXPECT_NEAR(padding.along(Eigen::Vector3d::UnitZ(), body, tipRow(cell.arm)), 2 * 5e-4, 1e-12);
  EXPECT_NEAR(padding.of(body, 0), 2 * 3e-4, 1e-12);
}

TEST(Padding, NoPointOfABodyDeviatesMore) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Workcell cell = withCovariance(seed, 1e-3);
    const BasePadding padding(cell, 1);
    const Capsule body{Eigen::Vector3d(normal(random), normal(random), normal(random)),
                       Eigen::Vector3d(normal(random), normal(random), normal(random)), 0.1};
    const Eigen::Vector3d direction = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    for (int k = 0; k <= 50; ++k) {
      const Eigen::Vector3d aside = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
      const Eigen::Vector3d p = body.from + k / 50. * (body.to - body.from) + body.radius * aside;
      const Eigen::Vector3d r = p - cell.X_WB.translation();
      Eigen::Matrix<double, 3, 6> J;
      J.leftCols<3>().setIdentity();
      for (int axis = 0; axis < 3; ++axis) J.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(r);
      const Eigen::Matrix3d covariance = J * cell.base_covariance * J.transpose();
      EXPECT_LE(std::sqrt(covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff()), padding.of(body, 0));
      EXPECT_LE(std::sqrt(direction.dot(covariance * direction)), padding.along(direction, body, 0) + 1e-15);
    }
  }
}

TEST(Padding, IsTakenOffInEachPostureAlikeByThePlannersDistancesAndTheProofs) {
  Workcell cell = withCovariance(3, 2e-4);
  for (std::size_t row = 0; row < cell.arm.rows.size(); ++row)
    cell.row_deviations.push_back(1e-4 * static_cast<double>(row));
  const ArmClearance bare(cell), padded(cell, 2);
  const BasePadding padding(cell, 2);
  Scene scene = cell.scene;
  LipschitzMargins proof(scene, padding);
  std::mt19937_64 random(2);
  for (int k = 0; k < 200; ++k) {
    const Eigen::VectorXd q = testing::randomPosture(cell.arm, random);
    const Clearance without = bare.at(q, ContactRule::kApproach), with = padded.at(q, ContactRule::kApproach);
    if (std::isnan(without.margin) || without.distance < 0) continue;
    EXPECT_LE(with.margin, without.margin + 1e-12);
    double bow = 0;
    const auto frames = bodyFrames(cell, q, &bow);
    EXPECT_NEAR(proof.at(frames, 1e-7, 0, nullptr) - bow, with.margin, 1e-6);
    // If the base, and the arm with it, is off by two standard deviations along any axis of the covariance, the margin
    // is at least the padded margin.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> axes(cell.base_covariance);
    for (int axis = 0; axis < 6; ++axis) {
      const Eigen::Matrix<double, 6, 1> step =
          2 * std::sqrt(std::max(0., axes.eigenvalues()[axis])) * axes.eigenvectors().col(axis);
      Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
      const Eigen::Vector3d turn = step.tail<3>();
      const Eigen::AngleAxisd rotation(turn.norm(), turn.norm() > 0 ? turn.normalized() : Eigen::Vector3d::UnitX());
      X = Eigen::Translation3d(cell.X_WB.translation() + step.head<3>()) * rotation *
          Eigen::Translation3d(-cell.X_WB.translation());
      auto moved = frames;
      for (auto& frame : moved) frame = X * frame;
      EXPECT_GE(CollisionWorld(scene).closest(moved).margin - bow, with.margin - 1e-6);
    }
  }
}

}  // namespace
}  // namespace tubeplan::planner
