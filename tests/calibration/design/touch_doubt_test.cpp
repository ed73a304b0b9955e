// For an arm with uncertain parameters, the accuracy forecast for touches must agree with that of a calibration from
// these touches.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "calibration/design/next_measurements.hpp"
#include "calibration/design/touch_choice.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// An arm with its base pose, and with candidate touches and work postures at random joint positions.
struct DoubtedCell {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB;
  std::vector<MeasurementCandidate> candidates;
  Work work;
};

DoubtedCell doubtedCell(const std::string& name, int candidates = 8) {
  const app::Cell cell = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/" + name);
  DoubtedCell doubted{cell.arm, cell.X_WB, {}, {}};
  std::mt19937_64 random(7);
  for (int k = 0; k < candidates; ++k) {
    ProposedMeasurement touch;
    touch.kind = MeasurementKind::kTouch;
    touch.point = "H" + std::to_string(k);
    touch.q = deflection::randomJoints(cell.arm, random);
    touch.sigma = kTouchSigma;
    touch.known_W = predictTip(cell.arm, cell.X_WB, touch.q, 0).value;
    doubted.candidates.push_back({{touch}});
  }
  for (int k = 0; k < 6; ++k) doubted.work.postures.push_back(deflection::randomJoints(cell.arm, random));
  return doubted;
}

Estimate nothingTouched(const DoubtedCell& cell, const ArmUncertainty& doubt, double model_error = 0) {
  return estimateFrom(cell.arm, cell.X_WB, false, {}, {{}, true}, {doubt, model_error});
}

/// Returns touches of the candidates with these indices, with noise of the stated sigma.
std::vector<Measurement> noisyTouches(const DoubtedCell& cell, const std::vector<int>& candidates, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<Measurement> touches;
  for (const int k : candidates) {
    const auto& proposed = cell.candidates[static_cast<std::size_t>(k)].measurements.front();
    Measurement& touch = touches.emplace_back(conditionsOf(proposed));
    touch.id = touch.point;
    touch.p_W = *proposed.known_W;
    for (double& x : *touch.p_W) x += kTouchSigma * normal(random);
  }
  return touches;
}

/// Returns the standard deviation of a tip coordinate [m], as root mean square over the work postures, that follows
/// from the joint covariance of base and parameters in `base`.
double tipSigmaBy(const BaseCalibration& base, const Work& work) {
  const auto& [numbers, covariance] = base.uncertainty;
  PredictionRequest request;
  request.by_base = true;
  for (const auto& number : numbers) request.numbers.push_back(deflection::Variable::number(number.path));
  double sum = 0;
  for (const auto& q : work.postures) {
    Measurement at;
    at.q = q;
    const Prediction tip = predictMeasurement(base.arm, base.X_WB, at, request);
    MatrixXd slopes(3, 6 + static_cast<Index>(numbers.size()));
    slopes.leftCols(6) = tip.by_base;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      slopes.col(6 + static_cast<Index>(k)) = tip.by_numbers.col(static_cast<Index>(k)) * slopeAt(numbers[k], 0);
    sum += (slopes * covariance * slopes.transpose()).trace();
  }
  return std::sqrt(sum / (3. * static_cast<double>(work.postures.size())));
}

class TouchDoubt : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Cells, TouchDoubt, ::testing::Values("mockup.yaml", "puma.yaml", "iiwa.yaml", "column.yaml"));

/// The forecast sigmas must equal those of a calibration from the same touches, for three and for five touches, whether
/// the arm is exact, has the usual or a larger uncertainty, or has a model error.
TEST_P(TouchDoubt, SigmasForetoldAreThoseOfTheCalibration) {
  const auto cell = doubtedCell(GetParam());
  ArmUncertainty more;
  more.stiffness = 0.3;
  more.length *= 2;
  const std::pair<ArmUncertainty, double> doubts[]{
      {ArmUncertainty{}, 0}, {more, 0}, {ArmUncertainty{}, 4 * kTouchSigma}, {ArmUncertainty::none(), 0}};
  for (const int count : {3, 5})
    for (const auto& [doubt, model_error] : doubts) {
      const auto estimate = nothingTouched(cell, doubt, model_error);
      const auto posed = poseDesign(estimate, cell.candidates, cell.work);
      const auto choice = chooseTouches(posed.problem, count);
      const auto next = forecastMeasurements(estimate, posed, judgeMeasurements(posed.problem, choice.chosen));
      BaseCalibrationOptions options;
      options.arm = doubt;
      options.model_error = model_error;
      options.finds_model_error = false;
      const auto base = calibrateBase(cell.arm, noisyTouches(cell, choice.chosen, 3), cell.X_WB, options);
      ASSERT_EQ(base.status, CalibrationStatus::kDone) << base.reason;
      ASSERT_EQ(next.numbers.size(), 6U);
      for (Index k = 0; k < 6; ++k) {
        const double stated = std::sqrt(base.covariance(k, k));
        EXPECT_NEAR(next.numbers[static_cast<std::size_t>(k)].after, stated, 0.03 * stated) << count << " " << k;
      }
      EXPECT_NEAR(next.tip_after.rms, tipSigmaBy(base, cell.work), 0.03 * next.tip_after.rms) << count;
      EXPECT_NEAR(choice.mean_sigma, next.tip_after.rms, 1e-6 * choice.mean_sigma) << count;
      for (const auto& step : next.design.steps) EXPECT_LT(step.most_helped, 6);
    }
}

/// The three touches chosen must be the best of all triples, each evaluated by the plain inverse of its information
/// matrix.
TEST_P(TouchDoubt, TheBestTripleIsBestBesideTheDoubt) {
  const auto cell = doubtedCell(GetParam());
  const auto problem = poseDesign(nothingTouched(cell, ArmUncertainty{}), cell.candidates, cell.work).problem;
  const double best = chooseTouches(problem, 3).mean_sigma;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i)
    for (int j = i + 1; j < 8; ++j)
      for (int k = j + 1; k < 8; ++k)
        least = std::min(least, tipSigma(problem.work, judgeMeasurements(problem, {i, j, k}).covariance).rms);
  EXPECT_NEAR(best, least, 1e-6 * least);
}

TEST_P(TouchDoubt, MoreDoubtOfStiffnessesLowersNoSigma) {
  const auto cell = doubtedCell(GetParam());
  VectorXd before = VectorXd::Zero(7);
  for (const double stiffness : {0., 0.02, 0.1, 0.3}) {
    ArmUncertainty doubt = ArmUncertainty::none();
    doubt.stiffness = stiffness;
    const auto estimate = nothingTouched(cell, doubt);
    const auto posed = poseDesign(estimate, cell.candidates, cell.work);
    const auto next = forecastMeasurements(estimate, posed, judgeMeasurements(posed.problem, {0, 1, 2, 3}));
    VectorXd now(7);
    for (Index k = 0; k < 6; ++k) now[k] = next.numbers[static_cast<std::size_t>(k)].after;
    now[6] = next.tip_after.rms;
    EXPECT_TRUE((now.array() >= before.array() * (1 - 1e-6)).all()) << stiffness << "\n" << now - before;
    before = now;
  }
}

/// The same touches must be chosen from touch plans as from a design problem, whether the arm is exact, has uncertain
/// parameters, or has a model error as well.
TEST_P(TouchDoubt, PlansAreChosenAsTheirMeasurementsAre) {
  const auto cell = doubtedCell(GetParam());
  std::vector<TouchPlan> plans;
  for (const auto& candidate : cell.candidates) {
    const auto& touch = candidate.measurements.front();
    plans.push_back({"", touch.point, *touch.known_W, touch.q});
  }
  for (const auto& doubt : {AdditionalUncertainty{}, AdditionalUncertainty{ArmUncertainty{}, 0},
                            AdditionalUncertainty{ArmUncertainty{}, 1e-3}})
    for (const int count : {3, 5}) {
      const auto posed = poseDesign(nothingTouched(cell, doubt.arm, doubt.model_error), cell.candidates, cell.work);
      const auto by_problem = chooseTouches(posed.problem, count);
      const auto by_arm = chooseTouches(cell.arm, cell.X_WB, plans, cell.work.postures, {count, kTouchSigma, doubt});
      EXPECT_EQ(by_problem.chosen, by_arm.chosen);
      EXPECT_NEAR(by_problem.mean_sigma, by_arm.mean_sigma, 1e-9 * by_arm.mean_sigma);
    }
}

/// The estimate from touches must equal that of a base calibration. Touches by an arm drawn from its own uncertainty
/// must hardly ever show a lack of fit.
TEST_P(TouchDoubt, TouchesMadeCountAsACalibrationCountsThem) {
  const auto cell = doubtedCell(GetParam());
  int lacking = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    auto touches = noisyTouches(cell, {0, 1, 2, 3, 4}, seed);
    const deflection::Arm drawn = drawnArm(cell.arm, ArmUncertainty{}, seed);
    for (auto& touch : touches)
      *touch.p_W += predictTip(drawn, cell.X_WB, touch.q, 0).value - predictTip(cell.arm, cell.X_WB, touch.q, 0).value;
    const auto base = calibrateBase(cell.arm, touches, cell.X_WB);
    ASSERT_EQ(base.status, CalibrationStatus::kDone) << base.reason;
    const auto estimate = estimateFrom(cell.arm, cell.X_WB, false, touches, {{}, true}, {ArmUncertainty{}, 0});
    lacking += estimate.model_error > 0 ? 1 : 0;
    EXPECT_DOUBLE_EQ(estimate.model_error, base.model_error);
    EXPECT_TRUE(placedAsEstimated(estimate).base_poses.front().X_WB.isApprox(base.X_WB, 1e-9));
    const MatrixXd covariance = estimate.information.inverse();
    for (Index k = 0; k < 6; ++k) {
      const double stated = std::sqrt(base.covariance(k, k));
      EXPECT_NEAR(std::sqrt(covariance(k, k)) * estimate.unknowns[static_cast<std::size_t>(k)].typical, stated,
                  0.03 * stated);
    }
  }
  EXPECT_LE(lacking, 1);
}

}  // namespace
}  // namespace tubeplan::calibration
