// Tests that measurements written as text are read back unchanged.
#include "app/formats/measurements/measurements_writer.hpp"

#include <algorithm>
#include <cmath>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurement_columns.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using calibration::CampaignRandom, calibration::Measurement, calibration::MeasurementKind;

Units unitsOfBlock(const std::string& text) { return Units(parseYaml(text, "units.yaml")); }

class MeasurementsWriter : public ::testing::Test {
 protected:
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  CampaignRandom random{3, CampaignRandom::Stream::kNoise};

  [[nodiscard]] Measurement randomMeasurement(int number) {
    Measurement m;
    m.id = "reading " + std::to_string(number);
    m.kind = static_cast<MeasurementKind>(number % static_cast<int>(calibration::measurementKinds().size()));
    m.point = "P" + std::to_string(number / 3);
    m.load = random.uniform(0, 200);
    m.q.resize(4);
    m.q << random.uniform(-3, 3), random.uniform(0, 3), random.uniform(-2, 2), random.uniform(-2, 2);
    if (m.kind != MeasurementKind::kTouch || random.index(2) == 0) m.p_W = random.vector(1);
    const auto columns = static_cast<Eigen::Index>(kindOf(m).columns.size());
    for (Eigen::Index k = 0; k < columns; ++k)
      if (k == 0 || calibration::valueColumnsOf(kindOf(m)).least > 1 || random.index(2) == 0)
        m.kind_values[k] = random.uniform(0.1, 2);
    if (kindOf(m).is_to_gravity) m.direction_W = -cell.arm.gravity_W;
    if ((!kindOf(m).lack && !kindOf(m).is_from_measurement) || kindOf(m).settle) m.p_W.reset();
    if (kindOf(m).turn_rows > 0) m.turn_sigma = random.uniform(1e-5, 1e-3);
    if (kindOf(m).is_place && random.index(3) == 0) m.p_TQ = random.vector(0.1);
    if (kindOf(m).has_direction) m.direction_W = random.vector(1).normalized();
    if (!kindOf(m).columns.empty() && calibration::valueColumnsOf(kindOf(m)).numbers.empty())
      m.kind_values[0] = 0.01;  // all measurements of a point state the same value
    m.sigma = random.uniform(1e-5, 1e-3);
    if (kindOf(m).has_coordinates && random.index(3) == 0) {
      m.sigma_W = Eigen::Vector3d(random.uniform(1e-5, 1e-3), random.uniform(1e-5, 1e-3), random.uniform(1e-5, 1e-3));
      m.sigma = std::sqrt(m.sigma_W->squaredNorm() / 3);
      if (random.index(2) == 0)
        m.correlation_W = Eigen::Vector3d(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0, 0.4));
    }
    if (kindOf(m).may_be_of_row && random.index(2) == 0) m.row = random.index(static_cast<int>(cell.arm.rows.size()));
    if (kindOf(m).is_from_measurement) relate(m);
    return m;
  }

  /// Makes the measurement relative to the previous measurement: it measures the displacement vector or its length.
  void relate(Measurement& m) {
    auto before = std::make_shared<Measurement>();
    const int number = std::stoi(m.id.substr(8));
    before->id = "reading " + std::to_string(number - 1);
    m.reference = before;
    if (random.index(2) == 0)
      m.p_W.reset();
    else
      m.kind_values.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  /// Sets random conditions, and the same set-up for measurements that refer to one another.
  void addConditions(Measurement& m) {
    const int number = std::stoi(m.id.substr(8));
    m.setup = "S" + std::to_string((kindOf(m).is_from_measurement ? number - 1 : number) / 100);
    for (int k = 0; k < 4; ++k) m.approach_directions.push_back(random.index(3) - 1);
    for (const auto& kind : deflection::kConditionKinds)
      m.conditions[kind.condition] = kind.usual + random.uniform(0, 1e4);
    m.is_held_out = random.index(2) == 1;
  }

  static void expectSame(const Measurement& a, const Measurement& b) {
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.setup, b.setup);
    EXPECT_EQ(a.approach_directions, b.approach_directions);
    EXPECT_EQ(a.is_held_out, b.is_held_out);
    EXPECT_NEAR(a.load, b.load, 1e-9);
    EXPECT_LE((a.q - b.q).lpNorm<Eigen::Infinity>(), 1e-11) << "half of the twelfth digit of 180 deg is 9e-12 rad";
    ASSERT_EQ(a.p_W.has_value(), b.p_W.has_value());
    if (a.p_W) {
      EXPECT_LE((*a.p_W - *b.p_W).norm(), 1e-10);
    }
    const auto expectNear = [](double x, double y, double tolerance) {
      EXPECT_EQ(std::isnan(x), std::isnan(y));
      if (!std::isnan(x)) {
        EXPECT_NEAR(x, y, tolerance);
      }
    };
    for (int k = 0; k < 3; ++k) expectNear(a.kind_values[k], b.kind_values[k], 1e-10);
    expectNear(a.turn_sigma, b.turn_sigma, 1e-14);
    ASSERT_EQ(a.p_TQ.has_value(), b.p_TQ.has_value());
    if (a.p_TQ) {
      EXPECT_LE((*a.p_TQ - *b.p_TQ).norm(), 1e-10);
    }
    ASSERT_EQ(a.direction_W.has_value(), b.direction_W.has_value());
    if (a.direction_W) {
      EXPECT_LE((*a.direction_W - *b.direction_W).norm(), 1e-10);
    }
    expectNear(a.sigma, b.sigma, 1e-14);
    ASSERT_EQ(a.sigma_W.has_value(), b.sigma_W.has_value());
    if (a.sigma_W) {
      EXPECT_LE((*a.sigma_W - *b.sigma_W).norm(), 1e-14);
    }
    ASSERT_EQ(a.correlation_W.has_value(), b.correlation_W.has_value());
    if (a.correlation_W) {
      EXPECT_LE((*a.correlation_W - *b.correlation_W).norm(), 1e-11);
    }
    EXPECT_EQ(a.row, b.row);
    ASSERT_EQ(a.reference != nullptr, b.reference != nullptr);
    if (a.reference) {
      EXPECT_EQ(a.reference->id, b.reference->id);
    }
    for (const auto& kind : deflection::kConditionKinds)
      expectNear(a.conditions[kind.condition], b.conditions[kind.condition], 1e-7);
  }

  void expectRoundTrip(const std::vector<Measurement>& measurements, const Units& units) const {
    const auto again = parseMeasurements(measurementsCsv(measurements, cell.arm, units), "m.csv", cell.arm);
    ASSERT_EQ(again.size(), measurements.size());
    for (std::size_t k = 0; k < measurements.size(); ++k) expectSame(measurements[k], again[k]);
  }
};

TEST_F(MeasurementsWriter, WhatItWritesReadsAsItWasInAnyUnits) {
  std::vector<Measurement> plain, full;
  for (int k = 0; k < 200; ++k) plain.push_back(randomMeasurement(k));
  full = plain;
  for (auto& measurement : full) addConditions(measurement);
  for (const char* units : {"{length: in, angle: deg, force: lbf, temperature: degF, time: min}",
                            "{length: mm, angle: rad, force: N, temperature: degC, time: s}"}) {
    const auto has = [&](auto question) { return std::any_of(plain.begin(), plain.end(), question); };
    EXPECT_TRUE(has([](const auto& m) { return m.row.has_value(); }));
    EXPECT_TRUE(has([](const auto& m) { return m.correlation_W.has_value(); }));
    expectRoundTrip(plain, unitsOfBlock(units));
    expectRoundTrip(full, unitsOfBlock(units));
  }
}

TEST_F(MeasurementsWriter, WritesTheColumnsThatMeasurementsHaveInTheirOrder) {
  Measurement measurement = randomMeasurement(0);
  measurement.p_TQ.reset();
  EXPECT_TRUE(measurementsCsv({measurement}, cell.arm, cell.units)
                  .starts_with("id,kind,point,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,"
                               "sigma_in\nreading 0,"));
  addConditions(measurement);
  measurement.is_held_out = true;
  measurement.kind = MeasurementKind::kDistance;
  measurement.kind_values[0] = 1;
  measurement.p_TQ.reset();
  std::string conditions;
  for (const auto& kind : deflection::kConditionKinds) conditions += conditionColumn(kind, cell.units) + ",";
  EXPECT_TRUE(conditions.starts_with("temperature_degF,time_min,"));
  expectSays(
      measurementsCsv({measurement}, cell.arm, cell.units),
      "id,kind,point,setup,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,distance_in,sigma_in,"
      "theta1_dir,theta2_dir,theta3_dir,theta4_dir," +
          conditions + "split\n");
}

TEST_F(MeasurementsWriter, KeepsNamesWithCommasAndQuotesWhole) {
  Measurement measurement = randomMeasurement(0);
  measurement.id = "a,b";
  measurement.point = "the \"third\" one ";
  expectRoundTrip({measurement}, cell.units);
}

TEST_F(MeasurementsWriter, LeavesOutASigmaThatIsNotStated) {
  std::vector<Measurement> measurements{randomMeasurement(0), randomMeasurement(4)};
  measurements[1].sigma = std::numeric_limits<double>::quiet_NaN();
  expectRoundTrip(measurements, cell.units);
}

TEST_F(MeasurementsWriter, WritesTouchesThatCalibrateReads) {
  std::vector<Measurement> touches(3);
  const Eigen::Vector4d q(0.1, 1, -0.5, 0.2);
  const char* const holes[] = {"R10C20", "R12C70", "R30C57"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto name = *tubesheets::parseTubeName(holes[k]);
    const auto* tube = cell.sheet->find(name.row, name.column);
    const calibration::TouchPlan plan{"T" + std::to_string(k), holes[k], {tube->x, tube->y, 0}, {}};
    touches[k] = calibration::plannedTouch(plan, q * (1 + 0.1 * k), 10, 1e-4);
  }
  const auto measurements = parseMeasurements(touchesCsv(touches, cell), "t.csv", cell.arm, &*cell.sheet);
  const auto again = touchesOf(measurements, cell, "t.csv");
  ASSERT_EQ(again.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(again[k].point, touches[k].point);
    EXPECT_LE((*again[k].p_W - *touches[k].p_W).norm(), 1e-10);
    EXPECT_LE((again[k].q - touches[k].q).norm(), 1e-11);
    EXPECT_NEAR(again[k].load, 10, 1e-9);
    EXPECT_NEAR(again[k].sigma, 1e-4, 1e-14);
  }
}

}  // namespace
}  // namespace tubeplan::app
