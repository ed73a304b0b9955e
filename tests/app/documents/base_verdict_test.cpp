// `calibrate` refuses touches that do not fit and says what to do, and warns of a base that is implausibly far from
// nominal.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

/// Returns the touches with the column of every hole shifted by `columns`, and without coordinates, which would reveal
/// the mistake.
std::string withColumnsMoved(const std::string& touches, int columns) {
  std::istringstream lines(touches);
  std::string text;
  std::ptrdiff_t x = -1;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    if (const auto at = fields.at(2).find('C'); at != std::string::npos)
      fields[2] = fields[2].substr(0, at + 1) + std::to_string(std::stoi(fields[2].substr(at + 1)) + columns);
    if (x < 0) x = std::find(fields.begin(), fields.end(), "x_in") - fields.begin();
    fields.erase(fields.begin() + x, fields.begin() + x + 3);
    for (std::size_t k = 0; k < fields.size(); ++k) text += (k ? "," : "") + fields[k];
    text += "\n";
  }
  return text;
}

class BaseVerdicts : public ProgramTest {
 protected:
  BaseVerdicts() {
    for (const char* name : {"mockup.yaml", "mockup-true.yaml", "cobra-arm.yaml", "cobra-arm-true.yaml"})
      write(name, contentOf(shippedCells() / name));
    // This cell states that its arm is exact, so touches that do not fit show that the model is wrong.
    write("exact.yaml", contentOf(shippedCells() / "mockup.yaml") + "uncertainty: none\n");
  }

  /// Simulates touches of six holes with the model of `cell` as the true arm.
  void touch(const std::string& cell, const std::string& more = "") const {
    ASSERT_EQ(run("simulate " + cell + " --design bowl --readings 6 --loads 0 --seed 3 --out set" + more).exit_code, 0);
  }

  struct Found {
    int exit_code;
    json figures;
    std::string text;
  };
  [[nodiscard]] Found calibrated(const std::string& cell, const std::string& touches) const {
    const std::string question = "calibrate " + cell + " " + touches;
    const Outcome figures = run(question + " --json -"), text = run(question);
    return {text.exit_code, json::parse(figures.out, nullptr, false), text.out};
  }
};

TEST_F(BaseVerdicts, AGoodFitIsSaidToBeGood) {
  touch("mockup.yaml");
  const Found found = calibrated("mockup.yaml", "set/measurements.csv");
  EXPECT_EQ(found.exit_code, 0) << found.text;
  EXPECT_EQ(found.figures["verdict"], "adequate");
}

TEST_F(BaseVerdicts, AFitThatChiSquareRefusesExitsWithOneAndSaysWhatToDo) {
  ASSERT_EQ(run("plan exact.yaml --touches auto --truth mockup-true.yaml --tubes spread:2 --out made").exit_code, 0);
  const Found found = calibrated("exact.yaml", "made/touches.csv");
  EXPECT_EQ(found.exit_code, 1);
  EXPECT_EQ(found.figures["status"], "done");
  EXPECT_EQ(found.figures["verdict"], "falls-short");
  EXPECT_NE(found.text.find("fourth hole"), std::string::npos) << found.text;
  EXPECT_NE(found.text.find("compare"), std::string::npos) << found.text;
}

TEST_F(BaseVerdicts, HolesOneColumnOffAreWarnedOf) {
  touch("mockup.yaml", " --base-error 0.05,0.05");
  const std::string touches = contentOf(folder / "set/measurements.csv");
  write("named.csv", withColumnsMoved(touches, 0));
  write("column.csv", withColumnsMoved(touches, 1));
  // By default the base may be half an inch off its nominal pose; a real shift by one column is then more probable than
  // a miscount.
  EXPECT_FALSE(calibrated("mockup.yaml", "column.csv").figures["nominal"]["implausible"]);
  std::string cell = contentOf(folder / "mockup.yaml");
  const std::string known = "known: false";
  write("placed.yaml", cell.replace(cell.find(known), known.size(), "known: false, prior: {shift: 0.1, turn: 0.1}"));
  const Found honest = calibrated("placed.yaml", "named.csv"), found = calibrated("placed.yaml", "column.csv");
  EXPECT_FALSE(honest.figures["nominal"]["implausible"]) << honest.text;
  EXPECT_TRUE(found.figures["nominal"]["implausible"]);
  EXPECT_EQ(found.figures["verdict"], "adequate") << "touches alone cannot tell";
  EXPECT_NEAR(std::abs(found.figures["nominal"]["pitches"][0].get<double>()), 1, 0.05);
  EXPECT_NE(found.text.find("one column off"), std::string::npos) << found.text;
}

TEST_F(BaseVerdicts, ABaseFarFromNominalIsWarnedOfInPitchesAndDegrees) {
  touch("mockup.yaml");
  std::string cell = contentOf(folder / "mockup.yaml");
  const std::string base = "position: [0, 43.0, -44.0]";
  cell.replace(cell.find(base), base.size(), "position: [39370, 43.0, -44.0]");
  write("far.yaml", cell);
  const Found found = calibrated("far.yaml", "set/measurements.csv");
  EXPECT_TRUE(found.figures["nominal"]["implausible"]);
  EXPECT_LT(found.figures["nominal"]["pitches"][0], -30000);
  EXPECT_NE(found.text.find("pitches"), std::string::npos);
  EXPECT_NE(found.text.find("warning"), std::string::npos);
  // With a prior that permits any base, no distance from nominal is reported as unexpected.
  const std::string known = "known: false";
  cell.replace(cell.find(known), known.size(), "known: false, prior: {shift: 50000, turn: 10}");
  write("anywhere.yaml", cell);
  EXPECT_EQ(calibrated("anywhere.yaml", "set/measurements.csv").text.find("but at most"), std::string::npos);
}

}  // namespace
}  // namespace tubeplan::app
