// Sensitivity of the tip to each parameter of the arm, tested with the Cobra arm.
#include "calibration/design/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/estimation/base_calibration.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

using deflection::Arm;

const std::vector<std::pair<double, double>> kHolesAtWork{{-40, 10}, {38, 12},  {10, 45}, {-2, 12},
                                                          {3, 20},   {-25, 30}, {28, 32}, {0, 38}};

struct Case {
  TouchedCell cell = touchedCell(kHolesAtWork);
  SensitivityTask task;
  Case() {
    for (const auto& plan : cell.plans) task.work.push_back(plan.q_start);
    task.touches = {cell.plans[0].q_start, cell.plans[1].q_start, cell.plans[2].q_start};
    task.hole_axis_W = Eigen::Vector3d::UnitZ();
  }
  [[nodiscard]] Sensitivity find() const { return findSensitivities(cell.arm, cell.X_WB_nominal, task); }
};

/// Returns the tip position of the unloaded arm in the world frame [m].
Eigen::Vector3d tipOf(const Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q) {
  const Prediction tip = predictTip(arm, X_WB, q, 0);
  EXPECT_TRUE(tip.ok);
  return tip.value;
}

/// Returns noise-free touches at the first three planned postures, with the touched point at the tip position of `arm`.
std::vector<Measurement> touchesBy(const Arm& arm, const Case& c) {
  std::vector<Measurement> touches;
  for (int t = 0; t < 3; ++t) {
    const auto& plan = c.cell.plans[static_cast<std::size_t>(t)];
    const Eigen::Vector3d tip = tipOf(arm, c.cell.X_WB_nominal, plan.q_start);
    touches.push_back(plannedTouch({plan.id, plan.hole, tip, {}}, plan.q_start, 0, c.task.touch_sigma));
  }
  return touches;
}

Arm withMore(const Arm& arm, const deflection::Parameter& parameter, double more) {
  Arm changed = arm;
  deflection::locate(changed, parameter.path) += more;
  return changed;
}

const NumberSensitivity& numberOf(const Sensitivity& result, const std::string& name) {
  for (const auto& number : result.numbers)
    if (number.parameter.name == name) return number;
  throw std::runtime_error("no number " + name);
}

TEST(Sensitivity, DeflectionDerivativeIsTheDifferenceQuotientOfTheMeanSag) {
  for (const double load : {0., 130.}) {
    Case c;
    c.task.load = load;
    const auto result = c.find();
    ASSERT_EQ(result.status, SensitivityStatus::kDone) << result.reason;
    EXPECT_EQ(result.numbers.size(), deflection::parametersOf(c.cell.arm).size());
    EXPECT_NEAR(result.mean_deflection, meanDeflection(c.cell.arm, c.cell.X_WB_nominal, c.task), 1e-15);
    for (const auto& number : result.numbers) {
      const double step = number.parameter.value == 0 ? 1e-4 : 1e-3 * std::abs(number.parameter.value);
      const auto sag = [&](double more) {
        return meanDeflection(withMore(c.cell.arm, number.parameter, more), c.cell.X_WB_nominal, c.task);
      };
      // A weight of zero cannot be decreased, so a one-sided difference quotient of second order is used.
      const bool is_at_bound = number.parameter.value - step < number.parameter.lower;
      const double quotient = is_at_bound ? (4 * sag(step) - sag(2 * step) - 3 * sag(0)) / (2 * step)
                                          : (sag(step) - sag(-step)) / (2 * step);
      const double change = 1e-4 * std::abs(quotient) + 1e-9 * result.mean_deflection / step;
      EXPECT_NEAR(number.deflection, quotient, change) << number.parameter.name;
    }
  }
}

TEST(Sensitivity, StiffeningLessensSagAndWeightAddsToIt) {
  const auto result = Case().find();
  int stiffnesses = 0, weights = 0;
  for (const auto& number : result.numbers) {
    if (number.kind == NumberKind::kStiffness) {
      ++stiffnesses;
      EXPECT_LT(number.deflection, 0) << number.parameter.name;
    }
    if (number.kind == NumberKind::kWeight && number.parameter.value > 0) {
      ++weights;
      EXPECT_GT(number.deflection, 0) << number.parameter.name;
    }
  }
  EXPECT_EQ(stiffnesses, 8);
  EXPECT_EQ(weights, 7);
}

// If all joint stiffnesses and all beams' stiffnesses increase by the same fraction, the deflection must decrease by
// that fraction, to within 2 %, because deflection changes the lever arms by about 1 %.
TEST(Sensitivity, AllStiffnessesTogetherScaleTheSag) {
  const auto result = Case().find();
  double sum = 0;
  for (const auto& number : result.numbers)
    if (number.kind == NumberKind::kStiffness && !number.parameter.name.ends_with("Iz"))
      sum += number.deflection * number.parameter.value;
  EXPECT_NEAR(sum, -result.mean_deflection, 0.02 * result.mean_deflection);
}

// The predicted errors must equal those of a simulated calibration: an arm with one parameter changed by 0.1 % touches
// three holes, the nominal arm is calibrated from the touches, and its errors at the work postures are averaged.
TEST(Sensitivity, ErrorAfterCalibrationIsWhatACalibrationLeaves) {
  for (const auto& doubt : {ArmUncertainty::none(), ArmUncertainty{}}) {
    Case c;
    c.task.additional.arm = doubt;
    const auto result = c.find();
    for (const char* name : {"latch-link.beam.Iz", "mezzanine-platform.joint_stiffness.x", "forearm.dh.a",
                             "tool.weight.distributed", "latch-link.weight.end"}) {
      const auto& number = numberOf(result, name);
      const double step = 1e-3 * number.parameter.value;
      const Arm truth = withMore(c.cell.arm, number.parameter, step);
      BaseCalibrationOptions options;
      options.arm = doubt;
      const auto base = calibrateBase(c.cell.arm, touchesBy(truth, c), c.cell.X_WB_nominal, options);
      ASSERT_EQ(base.status, CalibrationStatus::kDone) << name << base.reason;
      double uncompensated = 0, known = 0;
      for (const auto& q : c.task.work) {
        const Eigen::Vector3d true_tip = tipOf(truth, c.cell.X_WB_nominal, q);
        uncompensated += (true_tip - tipOf(base.arm, base.X_WB, q)).head<2>().norm();
        known += (true_tip - tipOf(c.cell.arm, c.cell.X_WB_nominal, q)).head<2>().norm();
      }
      const auto n = static_cast<double>(c.task.work.size());
      EXPECT_NEAR(number.error * step, uncompensated / n, 0.01 * uncompensated / n) << name;
      EXPECT_NEAR(number.error_base_known * step, known / n, 0.01 * known / n) << name;
    }
  }
}

TEST(Sensitivity, UncompensatedErrorIsWhatRigidCalibrationLeaves) {
  Case c;
  const Arm rigid = deflection::rigidCopy(c.cell.arm);
  BaseCalibrationOptions blunt;
  blunt.mistaken_hole_p_value = 0;
  blunt.arm = ArmUncertainty::none();
  blunt.finds_model_error = blunt.finds_suspects = false;
  const auto base = calibrateBase(rigid, touchesBy(c.cell.arm, c), c.cell.X_WB_nominal, blunt);
  ASSERT_EQ(base.status, CalibrationStatus::kDone) << base.reason;
  double uncompensated = 0;
  for (const auto& q : c.task.work)
    uncompensated += (tipOf(c.cell.arm, c.cell.X_WB_nominal, q) - tipOf(rigid, base.X_WB, q)).head<2>().norm() /
                     static_cast<double>(c.task.work.size());
  // The prediction is linearised in the base's motion, about 1 in for an arm of 60 in, hence the tolerance.
  EXPECT_NEAR(c.find().mean_uncompensated, uncompensated, 0.01 * uncompensated);
}

TEST(Sensitivity, AKnownBaseAbsorbsNothing) {
  Case c;
  c.task.touches.clear();
  c.task.hole_axis_W.reset();
  const auto result = c.find();
  EXPECT_NEAR(result.mean_uncompensated, result.mean_deflection, 1e-12);
  for (const auto& number : result.numbers) EXPECT_DOUBLE_EQ(number.error, number.error_base_known);
}

TEST(Sensitivity, TouchesThatPlaceNoBaseAreTold) {
  Case c;
  c.task.touches = {c.task.work[0], c.task.work[0], c.task.work[0]};
  EXPECT_EQ(c.find().status, SensitivityStatus::kTouchesDoNotDetermineBase);
  c.task.work.clear();
  EXPECT_EQ(c.find().status, SensitivityStatus::kNotConverged);
}

}  // namespace
}  // namespace tubeplan::calibration
