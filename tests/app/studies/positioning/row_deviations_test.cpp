// The deviation that the arm's parameters add to its bodies, compared with the tip's covariance in other postures.
#include "app/studies/positioning/row_deviations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "app/formats/cell/workcell.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/studies/positioning/planned_visits.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

/// Returns the largest standard deviation of the tip in a posture beyond that of the base alone [m].
double beyondBaseAt(const planner::Workcell& model, const calibration::JointUncertainty& uncertainty,
                    const Eigen::VectorXd& q) {
  calibration::PredictionRequest request;
  request.by_base = true;
  for (const auto& number : uncertainty.numbers) request.numbers.push_back(deflection::Variable::number(number.path));
  calibration::MeasurementPredictor predictor(model.arm);
  const auto tip = predictor.predictTip(model.X_WB, {q, 0, gravityInBase(model.arm, model.X_WB)}, request);
  if (!tip.ok) return 0;
  Eigen::MatrixXd J(3, 6 + static_cast<Eigen::Index>(uncertainty.numbers.size()));
  J << tip.by_base, tip.by_numbers;
  for (std::size_t k = 0; k < uncertainty.numbers.size(); ++k)
    J.col(6 + static_cast<Eigen::Index>(k)) *= slopeAt(uncertainty.numbers[k], 0);
  const Eigen::Matrix3d together = J * uncertainty.covariance * J.transpose();
  const Eigen::Matrix3d base =
      J.leftCols<6>() * uncertainty.covariance.topLeftCorner<6, 6>() * J.leftCols<6>().transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> beyond(together - base);
  return std::sqrt(std::max(0., beyond.eigenvalues().maxCoeff()));
}

class RowDeviations : public ::testing::Test {
 protected:
  RowDeviations() : cell_(readCell((shippedCells() / "mockup.yaml").string())), model_(workcellOf(cell_, "test")) {}

  calibration::JointUncertainty calibrated() {
    const auto touches = touchesByTrueArm(model_, cell_, model_, 3);
    const auto both = calibrateBoth(model_, cell_, touches);
    EXPECT_EQ(both.flexible.status, calibration::CalibrationStatus::kDone);
    model_ = withBase(model_, both.flexible);
    return both.flexible.uncertainty;
  }

  Cell cell_;
  planner::Workcell model_;
};

TEST_F(RowDeviations, AreThoseOfTheTipBeyondTheBaseInOtherPostures) {
  const auto uncertainty = calibrated();
  ASSERT_FALSE(uncertainty.numbers.empty());
  const auto deviations = rowDeviations(model_, uncertainty);
  ASSERT_EQ(deviations.size(), model_.arm.rows.size());
  calibration::RandomStream random(99);
  constexpr int kDrawn = 300;
  double sum = 0;
  for (int k = 0; k < kDrawn; ++k) {
    Eigen::VectorXd q(model_.arm.jointCount());
    for (Eigen::Index j = 0; j < q.size(); ++j)
      q[j] = random.uniform(model_.arm.joint(static_cast<int>(j)).lower, model_.arm.joint(static_cast<int>(j)).upper);
    const double deviation = beyondBaseAt(model_, uncertainty, q);
    sum += deviation * deviation / kDrawn;
  }
  EXPECT_NEAR(deviations.back(), std::sqrt(sum), 0.15 * std::sqrt(sum));
}

TEST_F(RowDeviations, GrowTowardsTheTipAndVanishWithoutUncertainty) {
  const auto uncertainty = calibrated();
  const auto deviations = rowDeviations(model_, uncertainty);
  EXPECT_LE(deviations.front(), deviations.back());
  EXPECT_GT(deviations.back(), 0);
  EXPECT_TRUE(rowDeviations(model_, {{}, uncertainty.covariance.topLeftCorner<6, 6>()}).empty());
}

}  // namespace
}  // namespace tubeplan::app
