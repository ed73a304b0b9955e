// Properties that every kind of measurement in the table of measurement kinds must have.
#include "calibration/measurements/measurement_kinds.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "calibration/estimation/identification.hpp"
#include "deflection/rotation.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

Measurement anyMeasurement(const MeasurementKindRow& row) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  Measurement m;
  m.kind = row.kind;
  m.p_W = Eigen::Vector3d(0.3, -0.2, 0.5);
  m.direction_W = Eigen::Vector3d(0.6, 0, 0.8);
  if (row.settle) m.surface = Surface{{0.4, 0.1, -0.2}, {0.48, -0.6, 0.64}, 0.3};
  m.kind_values = {0.7, valueColumnsOf(row).least == 1 && row.columns.size() > 1 ? kNothing : 0.2, -0.3};
  return m;
}

/// Returns measurements of every kind, at the tip and at another point of the tool. Displacements are also given as a
/// length, step counts also with all steps entered.
std::vector<Measurement> measurementsOfEveryKind() {
  std::vector<Measurement> measurements;
  for (const MeasurementKindRow& row : measurementKinds()) {
    measurements.push_back(anyMeasurement(row));
    measurements.push_back(anyMeasurement(row));
    measurements.back().p_TQ = Eigen::Vector3d(0.02, -0.05, 0.03);
    if (row.is_from_measurement) {
      measurements.push_back(anyMeasurement(row));
      measurements.back().p_W.reset();
    }
    if (!row.counts_steps) continue;
    measurements.push_back(anyMeasurement(row));
    measurements.back().kind_values[1] = 0;
  }
  return measurements;
}

ToolPose anyTool() {
  return {{1.1, 0.4, -0.6}, deflection::rotationFromFixedAngles<double>(Eigen::Vector3d(0.4, -0.7, 1.2))};
}

TEST(MeasurementKinds, StandInTheOrderOfTheirEnumeration) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < measurementKinds().size(); ++k) {
    const MeasurementKindRow& row = measurementKinds()[k];
    EXPECT_EQ(static_cast<std::size_t>(row.kind), k) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(findMeasurementKind(row.name), &row);
  }
  EXPECT_EQ(findMeasurementKind("tuoch"), nullptr);
}

TEST(MeasurementKinds, SlopesAreDifferencesOfValues) {
  const ToolPose tool = anyTool();
  for (const Measurement& m : measurementsOfEveryKind()) {
    const char* name = kindOf(m).name;
    ASSERT_EQ(predictedValue(m, tool).size(), rowsOf(m)) << name;
    const MeasuredSlope slope = predictedSlope(m, tool);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(axis);
      const auto moved = [&](double sign) { return predictedValue(m, {tool.p_W + sign * step, tool.R_WT}); };
      const auto turned = [&](double sign) {
        return predictedValue(m, {tool.p_W, deflection::rotationFromVector<double>(sign * step) * tool.R_WT});
      };
      EXPECT_LE(((moved(1) - moved(-1)) / 2e-5 - slope.by_place.col(axis)).norm(), 1e-9) << name;
      MeasuredValue by_turn = MeasuredValue::Zero(rowsOf(m));
      if (slope.by_turn.size()) by_turn = slope.by_turn.col(axis);
      EXPECT_LE(((turned(1) - turned(-1)) / 2e-5 - by_turn).norm(), 1e-9) << name;
      EXPECT_TRUE(seesTurn(m) || slope.by_turn.size() == 0) << name;
    }
  }
}

TEST(MeasurementKinds, WhatIsRecordedWasMeasured) {
  const ToolPose tool = anyTool();
  for (const MeasurementKindRow& row : measurementKinds()) {
    // A touch records no value, because the touched place is the tip's position; a count records an offset, from which
    // the caller counts the steps.
    if (row.is_touch || row.settle || row.counts_steps) continue;
    Measurement m = anyMeasurement(row);
    row.record(tool, 1, MeasuredValue::Zero(row.rows), m);
    EXPECT_LE((row.measured(m) - row.value(m, tool)).norm(), 1e-12) << row.name;
  }
}

TEST(MeasurementKinds, WhatIsRecordedIsAllThatAMeasurementHasToState) {
  const KnownPlaces places{Eigen::Vector3d(0.3, -0.2, 0.5), Eigen::Vector3d(0.1, 0.2, -0.4),
                           Eigen::Vector3d(0.6, 0, 0.8), Eigen::Vector3d::UnitZ()};
  for (const MeasurementKindRow& row : measurementKinds()) {
    Measurement m;
    m.kind = row.kind;
    EXPECT_EQ(statesEnough(m), valueColumnsOf(row).least == 0) << row.name;
    if (row.state) row.state(places, m);
    row.record(anyTool(), 1, MeasuredValue::Zero(row.rows), m);
    if (row.counts_steps)
      m.kind_values[0] = 3;  // record() leaves the number of steps to the caller, who knows the tool
    m.point = "P1";
    EXPECT_TRUE(statesEnough(m)) << row.name;
    EXPECT_FALSE(row.lack && row.lack(m, row.name)) << row.name;
    if (!row.is_possible) continue;
    m.kind_values[0] = -0.1;
    EXPECT_FALSE(statesEnough(m)) << row.name << ": a length below zero";
  }
}

// The sines of the tilts equal the vertical components of the tool's axes, and their squares sum to one.
TEST(MeasurementKinds, TiltsAreTheElevationsOfTheToolsAxes) {
  const ToolPose tool = anyTool();
  Measurement m = anyMeasurement(kindOf(MeasurementKind::kTilt));
  m.direction_W = Eigen::Vector3d::UnitZ();
  m.kind_values.setZero();
  const MeasuredValue angles = predictedValue(m, tool) / kTurnLever;
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::sin(angles[k]), tool.R_WT(2, k), 1e-12);
    sum += std::pow(std::sin(angles[k]), 2);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

// For each kind of measurement, between 180 and 198 of 200 intervals of 95 % contain the truth; for correct intervals,
// this has a probability of 0.998.
TEST(MeasurementKinds, IntervalsHoldTheTruthAsOftenAsTheySay) {
  for (const MeasurementKindRow& row : measurementKinds()) {
    if (row.is_touch) continue;  // one inverse solution per touch is too slow; the tests of campaigns cover touches
    int holds = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const PlacedArm truth = cobra();
      MeasurementMaker maker(truth, seed, MeasurementMaker::Noise::kStated);
      maker.add(row.kind, 30);
      IdentificationOptions options;
      options.free = {{"tool.joint_stiffness.z"}, false};
      options.folds = 0;
      options.intervals_by_profile = false;
      const auto result = identify(truth, maker.measurements, options);
      if (result.status != IdentificationStatus::kDone) continue;
      const double value = deflection::findParameter(truth.arm, "tool.joint_stiffness.z")->value;
      ++count;
      holds += result.numbers.front().lower <= value && value <= result.numbers.front().upper;
    }
    EXPECT_EQ(count, 200) << row.name;
    EXPECT_GE(holds, 180) << row.name;
    EXPECT_LE(holds, 198) << row.name;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
