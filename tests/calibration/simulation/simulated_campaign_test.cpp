// Measurements of simulated campaigns must match the true arm, with noise as stated and plausible conditions.
#include "calibration/simulation/simulated_campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "tests/calibration/bench_campaign.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Vector3d;

/// Returns the tip position of the true arm in the world frame [m] for the joint readings of `reading`, under `load`
/// [N].
Vector3d tipOf(const CampaignTruth& truth, const Measurement& measurement, double load) {
  const auto base =
      std::find_if(truth.bases.begin(), truth.bases.end(), [&](const auto& b) { return b.setup == measurement.setup; });
  const auto shape = deflection::solveFlexibleKinematics(
      truth.arm, {measurement.q, load, deflection::gravityInBase(truth.arm, base->X_WB)}, {1e-14, 100});
  return base->X_WB * shape.X_BD.p;
}

TEST(SimulatedCampaign, ExactPositionsDeflectionsAndDistancesAreThoseOfTheTrueArm) {
  const CampaignTruth truth = benchTruth(2);
  for (const auto kind : {MeasurementKind::kPosition, MeasurementKind::kDeflection, MeasurementKind::kDistance}) {
    CampaignDesign design = designOf(kind, 0);
    design.setups = 2;
    const auto campaign = simulate(truth, design, 120);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
    ASSERT_EQ(campaign.measurements.size(), 120u);
    for (const auto& measurement : campaign.measurements) {
      const Vector3d tip = tipOf(truth, measurement, measurement.load);
      EXPECT_TRUE(std::isnan(measurement.sigma)) << "exact readings state no noise";
      double off = (tip - *measurement.p_W).norm();
      if (kind == MeasurementKind::kDeflection) off = (tip - tipOf(truth, measurement, 0) - *measurement.p_W).norm();
      if (kind == MeasurementKind::kDistance)
        off = std::abs((tip - *design.anchor_W).norm() - measurement.kind_values[0]);
      EXPECT_LE(off, 1e-9);
    }
  }
}

TEST(SimulatedCampaign, ExactTouchesMeetTheirPoints) {
  const CampaignTruth truth = benchTruth(3);
  for (const bool known : {true, false}) {
    CampaignDesign design = designOf(MeasurementKind::kTouch, 0);
    design.points_known = known;
    design.place = known ? CampaignPlace::kPlane : CampaignPlace::kAnywhere;
    design.postures_per_point = 2;
    design.setups = 3;
    const auto campaign = simulate(truth, design, 180);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
    ASSERT_EQ(campaign.points.size(), 30u);
    std::map<std::string, Vector3d> points;
    for (const auto& point : campaign.points) points[point.name] = point.p_W;
    for (const auto& measurement : campaign.measurements) {
      EXPECT_LE((tipOf(truth, measurement, measurement.load) - points.at(measurement.point)).norm(), 1e-9);
      EXPECT_EQ(measurement.p_W.has_value(), known);
      if (known) {
        EXPECT_EQ(*measurement.p_W, points.at(measurement.point));
        EXPECT_NEAR(measurement.p_W->z(), campaign.points.front().p_W.z(), 1e-12) << "one plane across gravity";
      }
    }
    for (std::size_t k = 0; k + 3 < campaign.measurements.size(); k += 6)
      EXPECT_GT((campaign.measurements[k].q - campaign.measurements[k + 3].q).norm(), 0.01) << "another posture";
  }
}

TEST(SimulatedCampaign, HolesAreTouchedWithTheToolAlongThemAndLookedAtFromBelow) {
  const app::Cell& cell = mockupCell();
  const CampaignTruth truth = drawTruth(withEncoders(cell.arm, 0), cell.X_WB);
  CampaignOptions options;
  options.measurements = 60;
  for (const auto& tube : cell.sheet->tubes)
    options.holes.push_back({"at " + std::to_string(tube.x), {tube.x, tube.y, 0}});
  for (const auto kind : {MeasurementKind::kTouch, MeasurementKind::kPosition}) {
    CampaignDesign design = designOf(kind, 0);
    design.place = CampaignPlace::kHoles;
    design.loads = {0};
    const auto campaign = simulateCampaign(truth, design, options);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
    for (const auto& measurement : campaign.measurements) {
      const auto shape = deflection::solveFlexibleKinematics(
          truth.arm, {measurement.q, measurement.load, deflection::gravityInBase(truth.arm, cell.X_WB)}, {1e-14, 100});
      const Vector3d tool_W = cell.X_WB.linear() * (shape.X_BD.R * truth.arm.tool_axis_L);
      EXPECT_GT(tool_W.z(), std::cos(0.15)) << "the tilt that no joint corrects is a few degrees";
      EXPECT_LE((cell.X_WB * shape.X_BD.p - *measurement.p_W).norm(), 1e-9);
      EXPECT_NEAR(measurement.p_W->z(), kind == MeasurementKind::kTouch ? 0 : -options.standoff, 1e-9);
    }
  }
}

TEST(SimulatedCampaign, AHoleComesAgainOnlyWhenNoOtherIsLeft) {
  const app::Cell& cell = mockupCell();
  CampaignOptions options;
  options.measurements = 45;
  for (std::size_t k = 0; k < cell.sheet->tubes.size(); k += 150) {
    const auto& tube = cell.sheet->tubes[k];
    options.holes.push_back({tubesheets::tubeName(tube.row, tube.column), {tube.x, tube.y, 0}});
  }
  CampaignDesign design = designOf(MeasurementKind::kTouch, 0);
  design.place = CampaignPlace::kHoles;
  design.loads = {0};
  const auto campaign = simulateCampaign(drawTruth(cell.arm, cell.X_WB), design, options);
  ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
  const std::size_t reached = campaign.points.size();
  EXPECT_LT(reached, options.holes.size() + 1);
  EXPECT_GE(reached, 20u);
  for (std::size_t k = 0; k < reached; ++k) EXPECT_EQ(campaign.measurements[k].point, campaign.points[k].name);
}

TEST(SimulatedCampaign, CoordinateNoiseHasTheStatedDeviation) {
  const CampaignTruth truth = benchTruth();
  const double sigma = 2e-4;
  for (const auto kind : {MeasurementKind::kPosition, MeasurementKind::kTouch, MeasurementKind::kDeflection,
                          MeasurementKind::kDistance}) {
    const CampaignDesign design = designOf(kind, sigma);
    const auto campaign = simulate(truth, design, 3000);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
    std::vector<double> errors;
    double sum = 0;
    for (const auto& measurement : campaign.measurements) {
      EXPECT_EQ(measurement.sigma, sigma);
      const Vector3d tip = tipOf(truth, measurement, measurement.load);
      Vector3d off = tip - *measurement.p_W;
      if (kind == MeasurementKind::kDeflection) off -= tipOf(truth, measurement, 0);
      if (kind == MeasurementKind::kDistance)
        errors.push_back((tip - *design.anchor_W).norm() - measurement.kind_values[0]);
      else
        errors.insert(errors.end(), {off.x(), off.y(), off.z()});
    }
    for (const double error : errors) sum += error;
    const double n = static_cast<double>(errors.size());
    EXPECT_NEAR(deviation(errors) / sigma, 1, 4 / std::sqrt(2 * n)) << "four standard errors";
    EXPECT_LE(std::abs(sum / n), 4 * sigma / std::sqrt(n));
  }
}

TEST(SimulatedCampaign, CoordinateNoiseHasTheStatedCovariance) {
  const CampaignTruth truth = benchTruth();
  CampaignDesign design = designOf(MeasurementKind::kPosition, 1e-4);
  design.sigma_W = Vector3d(1e-4, 5e-4, 3e-4);
  design.correlation_W = Vector3d(0.9, -0.4, -0.5);
  const auto campaign = simulate(truth, design, 3000);
  ASSERT_EQ(campaign.status, CampaignStatus::kDone) << campaign.reason;
  Eigen::Matrix3d drawn = Eigen::Matrix3d::Zero();
  for (const auto& measurement : campaign.measurements) {
    ASSERT_TRUE(measurement.sigma_W && measurement.correlation_W);
    const Vector3d off =
        (*measurement.p_W - tipOf(truth, measurement, measurement.load)).cwiseQuotient(*design.sigma_W);
    drawn += off * off.transpose() / 3000;
  }
  const Eigen::Matrix3d stated = correlationMatrix(*design.correlation_W);
  EXPECT_LE((drawn - stated).cwiseAbs().maxCoeff(), 4 * std::sqrt(2. / 3000)) << "four standard errors";
  for (auto change : {+[](CampaignDesign& d) { d.sigma_W->x() = 0; }, +[](CampaignDesign& d) { d.sigma_W.reset(); },
                      +[](CampaignDesign& d) { d.correlation_W->x() = -0.999; },
                      +[](CampaignDesign& d) { d.kind = MeasurementKind::kTilt; }}) {
    CampaignDesign wrong = design;
    change(wrong);
    EXPECT_EQ(simulate(truth, wrong, 30).status, CampaignStatus::kRefused);
  }
}

TEST(SimulatedCampaign, EncoderNoiseHasTheStatedDeviation) {
  const double sigma = 3.5e-5;
  const auto campaign = simulate(benchTruth(1, sigma), designOf(MeasurementKind::kPosition, 1e-4), 6000);
  ASSERT_EQ(campaign.status, CampaignStatus::kDone);
  // The three loads are measured at one posture, so their joint readings differ only by the encoders' noise.
  std::vector<double> differences;
  for (std::size_t k = 0; k + 2 < campaign.measurements.size(); k += 3) {
    const Eigen::VectorXd d = campaign.measurements[k + 1].q - campaign.measurements[k].q;
    differences.insert(differences.end(), d.begin(), d.end());
  }
  EXPECT_NEAR(deviation(differences) / (sigma * std::sqrt(2.)), 1,
              4 / std::sqrt(2 * static_cast<double>(differences.size())));
}

TEST(SimulatedCampaign, PosturesStayWithinTheirLimitsAndTheTipBeforeTheBase) {
  const CampaignTruth truth = benchTruth();
  const double reach = deflection::reachOf(truth.arm);
  for (const auto kind : {MeasurementKind::kPosition, MeasurementKind::kTouch}) {
    const auto campaign = simulate(truth, designOf(kind, 1e-4), 600);
    ASSERT_EQ(campaign.status, CampaignStatus::kDone);
    for (const auto& measurement : campaign.measurements) {
      for (int k = 0; k < measurement.q.size(); ++k) {
        EXPECT_GE(measurement.q[k], truth.arm.joint(k).lower);
        EXPECT_LE(measurement.q[k], truth.arm.joint(k).upper);
      }
      const Vector3d tip_B = truth.bases.front().X_WB.inverse() * tipOf(truth, measurement, measurement.load);
      EXPECT_GT(tip_B.z(), 0);
      EXPECT_GE(tip_B.norm(), 0.2 * reach);
    }
  }
}

TEST(SimulatedCampaign, SensesFollowTheMotionAndBothOccur) {
  const CampaignTruth truth = benchTruth();
  CampaignDesign design = designOf(MeasurementKind::kTouch, 1e-4);
  CampaignOptions options;
  options.measurements = 600;
  options.pace.overshoot = 0;
  const auto straight = simulateCampaign(truth, design, options).measurements;
  ASSERT_EQ(straight.size(), 600u);
  for (std::size_t k = 1; k < straight.size(); ++k)
    for (int joint = 0; joint < 4; ++joint) {
      const double way = straight[k].q[joint] - straight[k - 1].q[joint];
      if (std::abs(way) > 1e-8) {
        EXPECT_EQ(straight[k].approach_directions[joint], way > 0 ? 1 : -1);
      }
    }
  options.pace.overshoot = 0.5;
  const auto mixed = simulateCampaign(truth, design, options).measurements;
  for (int joint = 0; joint < 4; ++joint) {
    const auto up =
        std::count_if(mixed.begin(), mixed.end(), [&](const auto& m) { return m.approach_directions[joint] == 1; });
    EXPECT_NEAR(static_cast<double>(up), 300, 4 * std::sqrt(150.)) << "four standard errors";
  }
}

TEST(SimulatedCampaign, TimeGoesOnAndTheTemperatureDriftsSlowly) {
  for (const int measurements : {60, 1200}) {
    const auto campaign = simulate(benchTruth(), designOf(MeasurementKind::kPosition, 1e-4), measurements);
    double coldest = 1e9, warmest = -1e9, roughest = 0;
    EXPECT_EQ(campaign.measurements.front().conditions[Condition::kTime], 0);
    for (std::size_t k = 0; k < campaign.measurements.size(); ++k) {
      const double temperature = campaign.measurements[k].conditions[Condition::kTemperature];
      coldest = std::min(coldest, temperature);
      warmest = std::max(warmest, temperature);
      if (k == 0) continue;
      const double wait = campaign.measurements[k].conditions[Condition::kTime] -
                          campaign.measurements[k - 1].conditions[Condition::kTime];
      EXPECT_GE(wait, 60);
      EXPECT_LE(wait, 180);
      roughest =
          std::max(roughest, std::abs(temperature - campaign.measurements[k - 1].conditions[Condition::kTemperature]));
    }
    EXPECT_GT(warmest - coldest, 5);
    EXPECT_LT(warmest - coldest, 16);
    EXPECT_LT(roughest, 3) << "slow against its range";
    EXPECT_NEAR((warmest + coldest) / 2, benchCell().arm.reference[Condition::kTemperature], 6);
  }
}

TEST(SimulatedCampaign, TheSameSeedReadsTheSameAndAnotherDoesNot) {
  const CampaignTruth truth = benchTruth(1, 1e-5);
  const CampaignDesign design = designOf(MeasurementKind::kTouch, 1e-4);
  const auto one = simulate(truth, design, 90, 7).measurements, same = simulate(truth, design, 90, 7).measurements,
             other = simulate(truth, design, 90, 8).measurements;
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].q, same[k].q);
    EXPECT_EQ(one[k].approach_directions, same[k].approach_directions);
    EXPECT_EQ(one[k].conditions[Condition::kTemperature], same[k].conditions[Condition::kTemperature]);
    EXPECT_NE(one[k].q, other[k].q);
  }
}

TEST(SimulatedCampaign, MoreNoiseDoesNotMeanOtherPostures) {
  const CampaignTruth truth = benchTruth();
  const auto quiet = simulate(truth, designOf(MeasurementKind::kPosition, 0), 90).measurements,
             loud = simulate(truth, designOf(MeasurementKind::kPosition, 1e-3), 90).measurements;
  for (std::size_t k = 0; k < quiet.size(); ++k) {
    EXPECT_EQ(quiet[k].q, loud[k].q);
    EXPECT_EQ(quiet[k].conditions[Condition::kTime], loud[k].conditions[Condition::kTime]);
    EXPECT_NE(*quiet[k].p_W, *loud[k].p_W);
  }
}

TEST(SimulatedCampaign, ACalibrationFindsTheBaseItWasMadeWith) {
  const CampaignTruth truth = benchTruth(1, 3.5e-5);
  CampaignDesign design = designOf(MeasurementKind::kTouch, kTouchSigma);
  design.place = CampaignPlace::kPlane;
  const auto found = calibrateBase(truth.arm, simulate(truth, design, 60).measurements, benchCell().X_WB);
  ASSERT_EQ(found.status, CalibrationStatus::kDone) << found.reason;
  EXPECT_GT(found.p_value, 1e-3);
  EXPECT_LT(found.p_value, 1 - 1e-3);
  EXPECT_LE((found.X_WB.translation() - truth.bases.front().X_WB.translation()).norm(), 0.01 * kInch);
}

}  // namespace
}  // namespace tubeplan::calibration
