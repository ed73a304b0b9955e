// The one error of a document, from outside: its unit by what was measured, its shares, and the readings set aside.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "calibration/measurements/measurement_kinds.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using calibration::MeasurementKindRow;
using nlohmann::json;

class ErrorFigures : public ProgramTest {
 protected:
  [[nodiscard]] json answer(const std::string& words) const {
    const Outcome outcome = run(words + " --json -");
    EXPECT_LT(outcome.exit_code, 2) << words << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Readings of that kind in the folder `set`; returns the cell that they are of.
  [[nodiscard]] std::string measure(const MeasurementKindRow& kind) const {
    std::string design = std::string("kind: ") + kind.name + "\nloads: [10, 30]\n";
    if (kind.turn_rows > 0) design += "turn_sigma: 0.01\n";
    if (kind.has_anchor) design += "anchor: [10, 60, 20]\n";
    if (kind.has_direction && !kind.is_to_gravity) design += "direction: [0, 0, 1]\n";
    if (!kind.names_hole) design += "postures: 16\n";
    (void)write("design.yaml", design);
    const std::string cell = shipped(kind.names_hole || kind.is_touch ? "mockup.yaml" : "bench.yaml");
    const Outcome made = run("simulate " + cell + " --design design.yaml --readings 32 --seed 3 --out set");
    EXPECT_EQ(made.exit_code, 0) << kind.name << "\n" << design << made.err;
    return cell;
  }

  /// Puts x of these rows of `set` half an inch off.
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

TEST_F(ErrorFigures, areInTheUnitOfWhatWasMeasured) {
  for (const MeasurementKindRow& kind : calibration::measurementKinds()) {
    SCOPED_TRACE(kind.name);
    const std::string cell = measure(kind);
    const json figures = answer("compare " + cell + " set/measurements.csv");
    const bool is_angle = kind.turn_rows == kind.rows;
    const std::string unit = figures["units"][is_angle ? "angle" : "length"];
    EXPECT_EQ(figures["error_unit"], unit);
    expectAddsUp(figures, kind.name);
    for (const json& worst : figures["worst"]) EXPECT_EQ(worst["unit"], unit);
    const std::string text = run("compare " + cell + " set/measurements.csv").out;
    expectSays(text, " " + unit + " as it stands");
    if (!is_angle) continue;
    // A stated noise of 0.01 deg in each angle, and what the encoders add.
    const double floor = figures["rms"]["noise_floor"];
    EXPECT_GT(floor, 0.01);
    EXPECT_LT(floor, 0.05);
    for (const json& worst : figures["worst"]) EXPECT_GT(worst["size"], 0) << worst;
  }
}

/// Hysteresis that the model lacks, and two readings that somebody wrote down wrong.
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
  EXPECT_NEAR(climbed["models"][0]["rms"]["heldout"], error, 1e-9);
  EXPECT_NEAR(diagnosed["rms"]["heldout_before"], error, 0.02 * error);
  EXPECT_NEAR(fitted["rms"]["heldout_after"], error, 0.02 * error);
  EXPECT_NEAR(diagnosed["rms"]["noise_floor"], compared["rms"]["noise_floor"], 1e-3 * error);
  EXPECT_EQ(diagnosed["error_budget"]["total"], diagnosed["rms"]["heldout_before"]);
}

TEST_F(ErrorFigures, aReportOfModelsBeginsWithItsAnswer) {
  const std::string cell = shipped("bench.yaml");
  ASSERT_EQ(run("simulate " + cell + " --design bench --readings 40 --seed 7 --out set").exit_code, 0);
  for (const std::string words : {"ladder set/measurements.csv " + cell + " --rigid",
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
