// Predicted tip position in the world frame, its derivatives with respect to the base, and its covariance due to
// encoder noise.
#include <gtest/gtest.h>

#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

Eigen::Vector3d tipAt(const TouchedCell& cell, const BaseStep& step, const Eigen::VectorXd& q) {
  const auto X_WB = moved(cell.X_WB_true, step);
  return X_WB *
         deflection::solveFlexibleKinematics(cell.arm, {q, 60, deflection::gravityInBase(cell.arm, X_WB)}, {1e-15, 200})
             .X_BD.p;
}

TEST(PredictTip, DerivativesByTheBaseIncludeGravity) {
  const auto cell = touchedCell();
  for (const auto& plan : cell.plans) {
    const auto tip = predictTip(cell.arm, cell.X_WB_true, plan.q_start, 60);
    ASSERT_TRUE(tip.ok);
    for (int k = 0; k < 6; ++k) {
      const double h = 1e-4;
      const Eigen::Vector3d slope =
          (tipAt(cell, h * BaseStep::Unit(k), plan.q_start) - tipAt(cell, -h * BaseStep::Unit(k), plan.q_start)) /
          (2 * h);
      EXPECT_LE((slope - tip.by_base.col(k)).norm(), 1e-6 * tip.by_base.col(k).norm()) << k;
    }
    // Since the arm sags, the derivative also includes the rotation of gravity in the base frame: without this part, it
    // would be wrong by over a thousandth of the lever.
    const Eigen::Vector3d lever = tip.value - cell.X_WB_true.translation();
    double without_gravity = 0;
    for (int k = 0; k < 3; ++k)
      without_gravity =
          std::max(without_gravity, (tip.by_base.col(3 + k) - Eigen::Vector3d::Unit(k).cross(lever)).norm());
    EXPECT_GT(without_gravity, 1e-3 * lever.norm());
  }
}

TEST(PredictTip, EncoderNoiseReachesTheTipThroughTheJacobian) {
  const auto cell = touchedCell();
  const auto tip = predictTip(cell.arm, cell.X_WB_true, cell.plans[0].q_start, 0);
  const Eigen::Matrix3d expected = std::pow(0.002 * kDegree, 2) * tip.by_joints * tip.by_joints.transpose();
  EXPECT_LE((encoderCovariance(cell.arm, tip.by_joints) - expected).norm(), 1e-9 * expected.norm());
}

}  // namespace
}  // namespace tubeplan::calibration
