#include "planner/padding.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "planner/arm_clearance.hpp"
#include "planner/separation.hpp"
#include "workcell.hpp"

namespace tubeplan::planner {
namespace {

TEST(Padding, NothingWithoutUncertaintyOrSigmas) {
  Workcell cell = testing::mockup();
  cell.base_covariance.setZero();
  EXPECT_EQ(paddingOf(cell, 3), 0);
  cell.base_covariance.setIdentity();
  EXPECT_EQ(paddingOf(cell, 0), 0);
}

TEST(Padding, AShiftAloneIsItsOwnDeviation) {
  Workcell cell = testing::mockup();
  cell.base_covariance.setZero();
  cell.base_covariance.diagonal().head<3>() << 1e-8, 4e-8, 1e-8;
  EXPECT_NEAR(paddingOf(cell, 3), 3 * 2e-4, 1e-12);
}

TEST(Padding, NoBodyPointDeviatesMoreUnderAnyCovariance) {
  const Workcell nominal = testing::mockup();
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 20; ++k) {
    Workcell cell = nominal;
    Eigen::Matrix<double, 6, 6> root;
    for (double& value : root.reshaped()) value = 1e-3 * normal(random);
    cell.base_covariance = root * root.transpose();
    const double padding = paddingOf(cell, 1);
    for (int posture = 0; posture < 20; ++posture) {
      const auto frames = bodyFrames(cell, testing::randomPosture(cell.arm, random), nullptr);
      for (const auto& body : cell.scene.bodies) {
        const Capsule around = transformed(frames[static_cast<std::size_t>(body.frame_index)],
                                           static_cast<const Solid&>(*body.shape).around());
        for (const auto& end : {around.from, around.to}) {
          const Eigen::Vector3d r = end - cell.X_WB.translation();
          Eigen::Matrix<double, 3, 6> J;
          J.leftCols<3>().setIdentity();
          for (int axis = 0; axis < 3; ++axis) J.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(r);
          const Eigen::Matrix3d covariance = J * cell.base_covariance * J.transpose();
          EXPECT_LE(std::sqrt(covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff()), padding);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tubeplan::planner
