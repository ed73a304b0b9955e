// For every kind of measurement, a run sheet names the columns to fill in, is refused while they are empty, and is
// accepted once they are filled in.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/documents/discrimination_json.hpp"
#include "app/formats/cell/simulation_input.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/studies/measurements/discrimination_candidates.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "tests/app/program.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {
namespace {

using calibration::Measurement, calibration::ProposedMeasurement, calibration::MeasurementCandidate;
using nlohmann::json;

/// A kind of measurement, with the cell and the design by which measurements are simulated; `design` holds the keys of
/// the design other than `kind`.
struct SheetCase {
  std::string name, kind, cell, design;
  bool is_length_alone = false;
};

std::vector<SheetCase> sheetCases() {
  return {{"position", "position", "bench.yaml", ""},
          {"touch", "touch", "holes.yaml", "loads: [0, 20]"},
          {"touchOfUnknownPoint", "touch", "bench.yaml", "points: unknown, loads: [0, 30]"},
          {"deflection", "deflection", "bench.yaml", "loads: [20]"},
          {"distance", "distance", "bench.yaml", "anchor: [90, 60, 20]"},
          {"axis", "axis", "bench.yaml", "anchor: [0, 0, 10], direction: [0, 0, 1]"},
          {"orientation", "orientation", "bench.yaml", "turn_sigma: 0.01"},
          {"pose", "pose", "bench.yaml", "turn_sigma: 0.01"},
          {"offset", "offset", "holes.yaml", "sigma: 0.005"},
          {"tilt", "tilt", "bench.yaml", "turn_sigma: 0.01, loads: [0, 30]"},
          {"tiltOfARow", "tilt", "bench.yaml", "turn_sigma: 0.01, rows: [forearm]"},
          {"steps", "steps", "holes.yaml", ""},
          {"relative", "relative", "bench.yaml", ""},
          {"relativeByLength", "relative", "bench.yaml", "", true},
          {"plane", "plane", "bench.yaml", "loads: [0, 30], postures_per_point: 8"},
          {"sphere", "sphere", "bench.yaml", "loads: [0, 30], postures_per_point: 8"},
          {"polar", "polar", "bench.yaml", "anchor: [90, 60, 20], turn_sigma: 0.001"},
          {"direction", "direction", "bench.yaml", "turn_sigma: 0.01"},
          {"directionOfARow", "direction", "bench.yaml", "turn_sigma: 0.01, rows: [forearm]"}};
}

class EveryRunSheet : public ProgramTest, public ::testing::WithParamInterface<SheetCase> {
 protected:
  /// Writes the cells and simulated measurements of the unaltered arm, and makes a run sheet of possible next
  /// measurements.
  void SetUp() override {
    (void)write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
    (void)write("bench.yaml", contentOf(shippedCells() / "bench.yaml"));
    (void)write("holes.yaml", changed(contentOf(shippedCells() / "mockup.yaml"), "known: false}",
                                      "known: true}\nidentify: [tool.tip]"));
    (void)write("design.yaml",
                "{kind: " + GetParam().kind + (GetParam().design.empty() ? "" : ", ") + GetParam().design + "}");
    cell = readCell((folder / GetParam().cell).string());
    makeMeasurements();
    const calibration::PlacedArm truth{cell.arm, {{"", cell.X_WB, true}}};
    candidates = discriminationCandidates(cell, truth, measurements, {.postures = 8, .most_loads = 2});
    ASSERT_FALSE(candidates.empty());
    next.times = 1;
    next.explanations.resize(2);
    for (std::size_t k = 0; k < candidates.size() && k < 3; ++k)
      next.measurements.push_back({static_cast<int>(k), 0, 1, 3});
    sheet = runSheetOf(next, candidates, measurements);
    for (const auto& proposed : sheet) {
      auto measurement = calibration::expectedMeasurement(truth, proposed);
      ASSERT_TRUE(measurement);
      if (kindOf(*measurement).counts_steps) measurement->kind_values[0] = static_cast<double>(cell.tool->steps.size());
      expected.push_back(*measurement);
    }
    text = runSheetCsv(sheet, cell.arm, cell.units);
    table = tubesheets::parseCsv(text);
    ASSERT_EQ(table.rows.size(), sheet.size());
  }

  /// Returns the sheet with its first `rows` rows filled in with expected values, except the last `less` of the columns
  /// to fill in.
  [[nodiscard]] std::string filled(std::size_t rows, std::size_t less = 0) const {
    const auto answers = tubesheets::parseCsv(measurementsCsv(expected, cell.arm, cell.units));
    std::string out = text.substr(0, text.find('\n') + 1);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      auto fields = table.rows[r].fields;
      const auto columns = fillInOf(sheet[r], cell.arm, cell.units).columns;
      for (std::size_t c = 0; r < rows && c + less < columns.size(); ++c)
        fields[*table.find(columns[c])] = answers.rows[r].fields[*answers.find(columns[c])];
      for (std::size_t c = 0; c < fields.size(); ++c) out += (c ? "," : "") + fields[c];
      out += "\n";
    }
    return out;
  }

  [[nodiscard]] Outcome compared(const std::string& sheet_text) const {
    (void)write("next.csv", sheet_text);
    return run("compare " + GetParam().cell + " set.csv next.csv --json figures.json");
  }

  Cell cell;
  std::vector<Measurement> measurements, expected;
  std::vector<MeasurementCandidate> candidates;
  calibration::DiscriminatingMeasurements next;
  std::vector<ProposedMeasurement> sheet;
  std::string text;
  tubesheets::CsvTable table;

 private:
  void makeMeasurements() {
    SimulationRequest request;
    request.design = (folder / "design.yaml").string();
    request.measurements = 16;
    const auto task = prepareSimulation(cell, request);
    const auto campaign = simulateMeasurements(cell, task, 3, {});
    ASSERT_EQ(campaign.status, calibration::CampaignStatus::kDone) << campaign.reason;
    measurements = campaign.measurements;
    for (auto& measurement : measurements) {
      if (!GetParam().is_length_alone) break;
      measurement.kind_values[0] = measurement.p_W->norm();
      measurement.p_W.reset();
    }
    (void)write("set.csv", measurementsCsv(measurements, cell.arm, cell.units));
  }
};

TEST_P(EveryRunSheet, AsksForTheColumnsOfItsKindAndHasNothingInThem) {
  const auto values = calibration::valueColumnsOf(*calibration::findMeasurementKind(GetParam().kind));
  std::vector<std::string> prefixes;
  for (const auto& column : values.numbers) prefixes.emplace_back(column.name);
  for (const auto& joint : cell.arm.joints())
    if (values.has_joints) prefixes.push_back(joint.name);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string& name = table.columns[c];
    const std::string quantity = name.substr(0, name.rfind('_'));
    if (!std::ranges::count(prefixes, quantity) && !std::ranges::count(prefixes, name)) continue;
    if (name.ends_with("_dir")) continue;  // the sheet states the approach direction of each joint
    for (const auto& row : table.rows) EXPECT_EQ(row.fields[c], "") << name;
  }
  for (const auto& proposed : sheet) {
    const auto fill = fillInOf(proposed, cell.arm, cell.units);
    EXPECT_GE(fill.least, 1);
    EXPECT_LE(static_cast<std::size_t>(fill.least), fill.columns.size());
    for (const auto& column : fill.columns) EXPECT_TRUE(table.find(column)) << column;
    for (const auto& column : fill.optional) EXPECT_TRUE(table.find(column)) << column;
  }
}

TEST_P(EveryRunSheet, GivenBackUntouchedIsRefused) {
  const auto outcome = compared(text);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "figures.json"));
  expectSays(outcome.err, "next.csv:2");
  if (sheet.size() > 1)
    for (const auto& proposed : sheet) expectSays(outcome.err, proposed.id);
  for (const auto& column : fillInOf(sheet.front(), cell.arm, cell.units).columns) expectSays(outcome.err, column);
}

TEST_P(EveryRunSheet, FilledInInPartIsRefused) {
  if (sheet.size() > 1) {
    const auto some = compared(filled(1));
    EXPECT_EQ(some.exit_code, 2);
    expectSays(some.err, "next.csv:3");
  }
  if (fillInOf(sheet.front(), cell.arm, cell.units).least < 2) return;  // a single number is a complete measurement
  const auto half = compared(filled(sheet.size(), 1));
  EXPECT_EQ(half.exit_code, 2);
  expectSays(half.err, "next.csv:2");
}

TEST_P(EveryRunSheet, FilledInJoinsTheMeasurements) {
  const auto outcome = compared(filled(sheet.size()));
  ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err << text;
  const json figures = json::parse(contentOf(folder / "figures.json"));
  std::set<std::string> joined;
  for (const auto& measurement : figures["readings"]) joined.insert(measurement["id"]);
  for (const auto& proposed : sheet) EXPECT_TRUE(joined.contains(proposed.id)) << proposed.id;
}

TEST_P(EveryRunSheet, PageAndReportAskForTheSameColumns) {
  json document = {{"sentence", ""}};
  next.status = calibration::DiscriminationStatus::kDone;
  addNextMeasurements(next, candidates, cell.arm, cell.units, document);
  const auto& listed = document["next_readings"];
  ASSERT_EQ(listed.size(), table.rows.size());
  for (std::size_t r = 0; r < sheet.size(); ++r) {
    const auto fill = fillInOf(sheet[r], cell.arm, cell.units);
    EXPECT_EQ(listed[r]["fill_in"],
              json({{"columns", fill.columns}, {"least", fill.least}, {"optional", fill.optional}}));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryRunSheet, ::testing::ValuesIn(sheetCases()),
                         [](const auto& info) { return info.param.name; });

TEST(EveryRunSheetCase, IsOfAKindAndEveryKindHasOne) {
  std::set<std::string> cases, kinds;
  for (const auto& of : sheetCases()) cases.insert(of.kind);
  for (const auto& kind : calibration::measurementKinds()) kinds.insert(kind.name);
  EXPECT_EQ(cases, kinds);
}

}  // namespace
}  // namespace tubeplan::app
