// Documents state errors in the unit of the measured quantity, contributions that add up to the error, and the
// measurements set aside, the same in every command.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "app/documents/comparison_json.hpp"
#include "app/documents/diagnosis_json.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "tests/app/program.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::app {
namespace {

using calibration::MeasurementKindRow;
using nlohmann::json;

constexpr double kHalfDegree = std::numbers::pi / 360;

class ErrorFigures : public ProgramTest {
 protected:
  [[nodiscard]] json answer(const std::string& words) const {
    const Outcome outcome = run(words + " --json -");
    EXPECT_LT(outcome.exit_code, 2) << words << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Adds half an inch to x in these rows of the measurements in folder `set`.
  void misread(const std::vector<std::size_t>& rows) const {
    std::vector<std::string> lines;
    std::istringstream text(contentOf(folder / "set/measurements.csv"));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    const auto cells = [](const std::string& line) {
      std::vector<std::string> list;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, ',');) list.push_back(cell);
      return list;
    };
    const auto heads = cells(lines.front());
    const auto x = std::find(heads.begin(), heads.end(), "x_in") - heads.begin();
    for (const std::size_t row : rows) {
      auto values = cells(lines.at(row));
      auto& value = values.at(static_cast<std::size_t>(x));
      value = std::to_string(std::stod(value) + 0.5);
      lines[row] = fmt::format("{}", fmt::join(values, ","));
    }
    (void)write("set/measurements.csv", fmt::format("{}\n", fmt::join(lines, "\n")));
  }

  static void expectAddsUp(const json& figures, const std::string& what) {
    const json& budget = figures["error_budget"];
    ASSERT_TRUE(budget.is_object()) << what << figures.dump().substr(0, 300);
    const auto square = [&](const char* key) {
      const double value = budget[key].get<double>();
      return std::copysign(value * value, value);
    };
    EXPECT_NEAR(square("explained") + square("remainder") + square("noise"), square("total"), 1e-9 * square("total"))
        << what << budget;
    EXPECT_EQ(budget["unit"], figures["error_unit"]) << what;
    EXPECT_EQ(budget["set_aside"], figures.value("set_aside", json::array()).size()) << what;
  }
};

/// Returns exact measurements of this kind, taken by a known arm. If the kind measures angles, one angle is wrong by
/// half a degree.
std::vector<calibration::Measurement> measurementsOf(const MeasurementKindRow& kind) {
  calibration::MeasurementMaker maker(calibration::cobra(), 5);
  if (kind.is_touch)
    maker.addTouches(8, {0, 30 * kPound}, true);
  else
    maker.add(kind.kind, 16);
  if (kind.turn_rows == 0) return maker.measurements;
  auto& own = maker.measurements[3].kind_values;
  // Changes the last angle: a change of an elevation turns the direction by the same angle, but one of an azimuth by
  // less.
  const auto from_last = std::make_reverse_iterator(own.end());
  *std::find_if(from_last, std::make_reverse_iterator(own.begin()), [](double a) { return std::isfinite(a); }) +=
      kHalfDegree;
  return maker.measurements;
}

TEST_F(ErrorFigures, areInTheUnitOfWhatWasMeasured) {
  const Units units = readCell((shippedCells() / "bench.yaml").string()).units;
  for (const MeasurementKindRow& kind : calibration::measurementKinds()) {
    SCOPED_TRACE(kind.name);
    const auto measurements = measurementsOf(kind);
    const auto result = calibration::compare(calibration::cobra(), measurements, {});
    ASSERT_EQ(result.status, calibration::ComparisonStatus::kDone) << result.reason;
    const json figures = comparisonJson(result, measurements, 0, units);
    const bool is_angle = kind.turn_rows == kind.rows;
    const std::string unit(is_angle ? units.angle().name : units.length().name);
    EXPECT_EQ(figures["error_unit"], unit);
    expectAddsUp(figures, kind.name);
    for (const json& worst : figures["worst"]) EXPECT_EQ(worst["unit"], unit);
    for (const json& measurement : figures["readings"]) EXPECT_EQ(measurement["size_unit"], unit);
    expectSays(comparisonText(figures), " " + unit + " as it stands");
    if (!is_angle) continue;
    EXPECT_EQ(figures["worst"][0]["id"], measurements[3].id);
    EXPECT_NEAR(figures["worst"][0]["size"].get<double>(), 0.5, 0.01);
    EXPECT_NEAR(figures["as_it_stands"]["worst"].get<double>(), 0.5, 0.01);
    EXPECT_NEAR(figures["rms"]["before"].get<double>(), 0.5 / std::sqrt(16), 0.01);
  }
}

/// For measurements that measure only angles, a diagnosis states the error of every measurement as an angle.
TEST_F(ErrorFigures, ofADiagnosisAreInTheUnitOfWhatWasMeasured) {
  const Units units = readCell((shippedCells() / "bench.yaml").string()).units;
  for (const MeasurementKindRow& kind : calibration::measurementKinds()) {
    if (kind.turn_rows == 0 || kind.turn_rows != kind.rows) continue;
    SCOPED_TRACE(kind.name);
    calibration::MeasurementMaker maker(calibration::cobra(), 5, calibration::MeasurementMaker::Noise::kStated);
    maker.add(kind.kind, 24);
    calibration::DiagnosisOptions options;
    options.most_causes = 1;
    const auto result = calibration::diagnose(calibration::cobra(), maker.measurements, options);
    const json figures = diagnosisJson(result, maker.measurements, units);
    ASSERT_FALSE(figures["readings"].empty());
    double square = 0;
    for (const json& measurement : figures["readings"]) {
      EXPECT_EQ(measurement["size_unit"], units.angle().name);
      EXPECT_EQ(measurement["size_explained"].size(), measurement["explained"].size());
      EXPECT_GT(measurement["size_before"].get<double>(), 0);
      square += std::pow(measurement["size_before"].get<double>(), 2);
    }
    const double rms = figures["rms"]["before"].get<double>();
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(figures["readings"].size())), rms, 1e-6 * rms);
  }
}

/// For measurements with hysteresis that the model lacks and two gross errors, all commands set the same measurements
/// aside and state the same errors.
TEST_F(ErrorFigures, areTheSameInEveryDocument) {
  const std::string cell = shipped("bench.yaml");
  const Outcome made = run("simulate " + cell +
                           " --design bench --readings 80 --seed 7 --spread 0.1 --hide hysteresis@theta4:0.06deg "
                           "--out set");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  misread({20, 50});
  const std::string set = " set/measurements.csv";
  const json compared = answer("compare " + cell + set), diagnosed = answer("diagnose " + cell + set + " --effects 1"),
             climbed = answer("ladder" + set + " " + cell),
             improved = answer("improve " + cell + set + " --out better.yaml"),
             fitted = answer("identify " + cell + set);
  for (const auto& [name, figures] : {std::pair{"compare", &compared},
                                      {"diagnose", &diagnosed},
                                      {"ladder", &climbed},
                                      {"improve", &improved},
                                      {"identify", &fitted}})
    expectAddsUp(*figures, name);
  EXPECT_FALSE(compared["set_aside"].empty());
  EXPECT_EQ(diagnosed["set_aside"], compared["set_aside"]);
  EXPECT_EQ(climbed["set_aside"], compared["set_aside"]);
  EXPECT_EQ(fitted["set_aside"], compared["set_aside"]);
  const double error = compared["rms"]["heldout_after"];
  EXPECT_NEAR(climbed["models"][0]["rms"]["heldout"].get<double>(), error, 1e-9);
  EXPECT_NEAR(fitted["rms"]["heldout_after"].get<double>(), error, 1e-3 * error);
  EXPECT_NEAR(diagnosed["rms"]["heldout_before"].get<double>(), error, 0.05 * error)
      << "its folds are fitted by itself";
  EXPECT_NEAR(diagnosed["rms"]["noise_floor"].get<double>(), compared["rms"]["noise_floor"].get<double>(),
              1e-3 * error);
  EXPECT_EQ(diagnosed["error_budget"]["total"], diagnosed["rms"]["heldout_before"]);
}

TEST_F(ErrorFigures, aReportOfModelsBeginsWithItsAnswer) {
  const std::string cell = shipped("bench.yaml");
  ASSERT_EQ(run("simulate " + cell + " --design bench --readings 40 --seed 7 --out set").exit_code, 0);
  for (const std::string& words : {"ladder set/measurements.csv " + cell + " --rigid",
                                   "improve " + cell + " set/measurements.csv --out better.yaml"}) {
    const json figures = answer(words + " --report page.html");
    const std::string sentence = figures["sentence"];
    EXPECT_TRUE(sentence.ends_with(".")) << sentence;
    const auto dumped = json(sentence).dump();
    expectSays(contentOf(folder / "page.html"), "\"sentence\":" + dumped);
    expectSays(run(words).out, sentence);
  }
}

}  // namespace
}  // namespace tubeplan::app
