// A count of steps bounds the offset of one section of the tool, also where the tool leans.
#include "calibration/measurements/counted_section.hpp"

#include <gtest/gtest.h>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/steps.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::AngleAxisd, Eigen::Vector2d, Eigen::Vector3d;

/// Returns a tool whose steps have random lengths, and tolerances that decrease.
tubesheets::SteppedTool randomTool(int steps, SeededRandom& random) {
  tubesheets::SteppedTool tool;
  double tolerance = 0.09 * kInch;
  for (int k = 0; k < steps; ++k) {
    tool.steps.push_back({0.7 * kInch - 2 * tolerance, tolerance});
    tool.lengths.push_back(drawnBetween(0.2, 1, random) * kInch);
    tolerance *= drawnBetween(0.4, 0.8, random);
  }
  return tool;
}

/// Returns a visit of the mock-up's arm with its tool nearly upright, or empty if the drawn posture is not upright.
std::optional<Measurement> uprightVisit(const app::Cell& cell, SeededRandom& random) {
  Measurement visit;
  visit.kind = MeasurementKind::kSteps;
  visit.q.resize(4);
  visit.q << drawnBetween(-1.5, 1.5, random), drawnBetween(0.6, 1.6, random), drawnBetween(-1.6, -0.4, random), 0;
  const auto axis = toolAxisAt(cell.arm, cell.X_WB, visit);
  if (!axis || !axis->isUpward()) return std::nullopt;
  const Vector2d lean = axis->lean();
  visit.q[3] -= std::atan(lean.norm()) * (lean.dot(toolAt(cell.arm, cell.X_WB, visit)->p_W.head<2>()) > 0 ? 1 : -1);
  return visit;
}

/// Returns the offset of the counted section from the hole [m].
double offsetOf(const Measurement& visit, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
  return steps::lateralOffset(visit, atMeasuredPoint(visit, *toolAt(arm, X_WB, visit))).norm();
}

TEST(CountedSection, HasAnOffsetWithinTheBoundsForAnyToolAndTilt) {
  SeededRandom random(4);
  app::Cell cell = shippedCell("mockup.yaml");
  const Eigen::Isometry3d X_WB = cell.X_WB;
  int visits = 0, leaning = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    cell.X_WB = X_WB * AngleAxisd(drawnBetween(-0.05, 0.05, random), Vector3d::UnitX());
    const auto tool = randomTool(1 + drawnBelow(8, random), random);
    auto visit = uprightVisit(cell, random);
    if (!visit) continue;
    const auto axis = toolAxisAt(cell.arm, cell.X_WB, *visit);
    if (!axis || !axis->isUpward() || axis->lean().norm() > 0.1) continue;
    const Vector2d lean = axis->lean();
    const Vector2d offset =
        0.08 * kInch * Vector2d(drawnBetween(-1, 1, random), drawnBetween(-1, 1, random)) * drawnBetween(0, 1, random);
    visit->p_W = toolAt(cell.arm, cell.X_WB, *visit)->p_W;
    visit->p_W->head<2>() -= offset;
    visit->kind_values[0] = tubesheets::stepsInserted(tool, offset, lean);
    settleCount(*visit, tool, cell.arm, cell.X_WB);
    // The tip rises vertically, but the model turns the section about the tip: the difference is of second order.
    const double slack = 2 * lean.squaredNorm() * 0.1 * kInch + 0.1 * std::pow(lean.norm(), 3) * kInch;
    const double off = offsetOf(*visit, cell.arm, cell.X_WB);
    EXPECT_GE(off, visit->kind_values[1] - slack) << visit->kind_values[0] << " of " << tool.steps.size();
    EXPECT_LE(off, visit->kind_values[2] + slack) << visit->kind_values[0] << " of " << tool.steps.size();
    ++visits;
    leaning += lean.norm() > 0.02;
  }
  EXPECT_GT(visits, 300);
  EXPECT_GT(leaning, 100);
}

TEST(CountedSection, OfAToolWithoutLengthsIsTheTip) {
  SeededRandom random(5);
  const app::Cell cell = shippedCell("mockup.yaml");
  for (int entered = 0; entered <= 3; ++entered) {
    auto tool = randomTool(3, random);
    tool.lengths.clear();
    Measurement visit;
    visit.kind_values[0] = entered;
    settleCount(visit, tool, cell.arm, cell.X_WB);
    EXPECT_FALSE(visit.p_QS);
    EXPECT_EQ(visit.kind_values[1], entered < 3 ? tool.steps[static_cast<std::size_t>(entered)].tolerance : 0);
    if (entered > 0) {
      EXPECT_EQ(visit.kind_values[2], tool.steps[static_cast<std::size_t>(entered) - 1].tolerance);
    }
  }
}

// A base that leans by a degree makes every tool lean. Counts of the true arm then agree with the true arm, and their
// mean offset, which is that of the holes, vanishes.
TEST(CountedSection, OfSimulatedVisitsAgreesWithTheTrueArmOnALeaningBase) {
  app::Cell cell = shippedCell("mockup.yaml");
  app::SimulationTask task;
  app::SimulationRequest request;
  request.design = "bowl";
  request.measurements = 100;
  task = app::prepareSimulation(cell, request);
  task.design.kind = MeasurementKind::kSteps;
  task.design.place = CampaignPlace::kHoles;
  task.design.loads = {0};
  cell.X_WB = task.truth.bases.front().X_WB = cell.X_WB * AngleAxisd(0.03, Vector3d(1, 1, 0).normalized());
  const auto campaign = app::simulateMeasurements(cell, task, 3, {});
  ASSERT_EQ(campaign.status, CampaignStatus::kDone);
  ASSERT_GT(campaign.measurements.size(), 60U);
  double lean = 0;
  for (const Measurement& visit : campaign.measurements) {
    const double off = offsetOf(visit, cell.arm, cell.X_WB), slack = 0.003 * kInch;  // encoder noise
    EXPECT_GE(off, visit.kind_values[1] - slack);
    EXPECT_LE(off, visit.kind_values[2] + slack);
    lean += toolAxisAt(cell.arm, cell.X_WB, visit)->lean().norm() / static_cast<double>(campaign.measurements.size());
  }
  EXPECT_GT(lean, 0.003);
}

}  // namespace
}  // namespace tubeplan::calibration
