// `tubeplan compare` exits with 0 for an adequate model, 1 for one that falls short and 2 for bad input, and sets
// outliers aside.
#include <fmt/format.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class CompareCommand : public ProgramTest {
 protected:
  /// Returns simulated position measurements of the bench cell, in its units, with a sigma of 0.002 in and encoder
  /// noise; `lost` is the half width of theta2's lost motion [deg].
  [[nodiscard]] std::string measurementsWith(double lost) const {
    const Cell cell = readCell((shippedCells() / "bench.yaml").string());
    boost::random::mt19937_64 random(4);
    boost::random::uniform_real_distribution<double> share(-1, 1);
    boost::random::normal_distribution<double> normal;
    std::string text =
        "id,kind,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in,"
        "theta1_dir,theta2_dir,theta3_dir,theta4_dir\n";
    for (int k = 0; k < 40; ++k) {
      Eigen::Vector4d read(100 * share(random), 60 + 50 * share(random), 60 * share(random), 60 * share(random));
      Eigen::Vector4i approach_directions;
      for (int& approach_direction : approach_directions) approach_direction = share(random) < 0 ? -1 : 1;
      calibration::Measurement measurement;
      measurement.load = cell.units.toInternal(10. * (k % 4), dimension::kForce);
      measurement.q =
          (read + Eigen::Vector4d(0, lost * approach_directions[1], 0, 0)) * cell.units.factor(dimension::kAngle);
      Eigen::Vector3d tip = calibration::predictMeasurement(cell.arm, cell.X_WB, measurement).value;
      tip /= cell.units.factor(dimension::kLength);
      for (auto& coordinate : tip) coordinate += 0.002 * normal(random);
      for (auto& angle : read) angle += 0.002 * normal(random);
      text +=
          fmt::format("{},position,{},{:.9f},{:.9f},{:.9f},{:.9f},{:.6f},{:.6f},{:.6f},0.002,{},{},{},{}\n", k + 1,
                      10 * (k % 4), read[0], read[1], read[2], read[3], tip[0], tip[1], tip[2], approach_directions[0],
                      approach_directions[1], approach_directions[2], approach_directions[3]);
    }
    return text;
  }
};

// A long name of a measurement is cut in the text output, but appears in full in the JSON.
TEST_F(CompareCommand, aMeasurementsNameIsCutInTheText) {
  const std::string name(10000, 'n');
  std::string text = measurementsWith(0.1);
  for (std::size_t at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at + 1)) text.insert(at + 1, name);
  (void)write("readings.csv", text);
  const Outcome outcome = run("compare " + shipped("bench.yaml") + " readings.csv");
  expectSays(outcome.out, "worst: reading " + name.substr(0, 60) + "... is off by");
  EXPECT_LT(outcome.out.size(), 5000u);
  const Outcome figures = run("compare " + shipped("bench.yaml") + " readings.csv --json -");
  EXPECT_EQ(json::parse(figures.out)["worst"][0]["id"].get<std::string>().substr(0, name.size()), name);
}

TEST_F(CompareCommand, anAdequateModelExitsWithZeroAndGivesEveryKey) {
  (void)write("readings.csv", measurementsWith(0));
  const Outcome outcome = run("compare " + shipped("bench.yaml") + " readings.csv --json -");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["verdict"], "adequate");
  EXPECT_TRUE(report["patterns"].empty());
  EXPECT_GT(report["tested"].size(), 40u);
  EXPECT_GT(report["p_value"], 0.01);
  EXPECT_NEAR(report["chi2_per_dof"], 1, 0.5);
  EXPECT_EQ(report["units"]["length"], "in");
  for (const char* key : {"before", "after", "noise_floor", "heldout_before", "heldout_after"})
    EXPECT_TRUE(report["rms"][key].is_number()) << key;
  for (const char* block : {"as_it_stands", "after_refit"})
    for (const char* key : {"rms", "mean", "worst", "chi2_per_dof", "p_value", "degrees_of_freedom", "noise_floor"})
      EXPECT_TRUE(report[block][key].is_number()) << block << " " << key;
  EXPECT_EQ(report["chi2_per_dof"], report["after_refit"]["chi2_per_dof"]);
  EXPECT_EQ(report["readings"].size(), 40u);
  EXPECT_EQ(report["readings"][5]["joints"].size(), 4u);
  EXPECT_EQ(report["joint_equivalents"]["after_refit"]["joints"][1]["unit"], "deg");
  EXPECT_EQ(report["worst"].size(), 10u);
  EXPECT_GE(report["worst"][0]["sigmas"], report["worst"][1]["sigmas"]);
}

TEST_F(CompareCommand, aModelThatFallsShortExitsWithOneAndSaysWhatItsErrorFollows) {
  (void)write("readings.csv", measurementsWith(0.03));
  const Outcome outcome = run("compare " + shipped("bench.yaml") + " readings.csv --json -");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["verdict"], "falls-short");
  ASSERT_FALSE(report["patterns"].empty());
  const json& first = report["patterns"][0];
  EXPECT_EQ(first["variable"], "sense of theta2");
  EXPECT_EQ(first["trend"].size(), 2u);
  EXPECT_LE(first["p_value"], 0.01);
  expectSays(first["sentence"], "The error follows the direction of approach of theta2: ");
  expectSays(first["sentence"], " in more ");
  expectSays(run("compare " + shipped("bench.yaml") + " readings.csv").out, "falls-short");
}

TEST_F(CompareCommand, itsPageDrawsTheErrorsOfEveryMeasurement) {
  (void)write("readings.csv", measurementsWith(0));
  const Outcome outcome = run("compare " + shipped("bench.yaml") + " readings.csv --report page.html");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = contentOf(folder / "page.html");
  EXPECT_NE(page.find("\"before\":["), std::string::npos);
  EXPECT_NE(page.find("\"after\":["), std::string::npos);
  EXPECT_NE(page.find("\"name\":\"theta1\""), std::string::npos);
}

TEST_F(CompareCommand, badInputExitsWithTwo) {
  (void)write("readings.csv", measurementsWith(0));
  (void)write("bad.yaml",
              changed(contentOf(shippedCells() / "bench.yaml"), "[tool.joint_stiffness.z", "[elbow.joint_stiffness.z"));
  std::filesystem::copy(shippedCells() / "cobra-arm.yaml", folder / "cobra-arm.yaml");
  const Outcome unknown = run("compare bad.yaml readings.csv --json -");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.out, "");
  expectSays(unknown.err, "elbow.joint_stiffness.z");
  const Outcome missing = run("compare " + shipped("bench.yaml") + " nowhere.csv --json -");
  EXPECT_EQ(missing.exit_code, 2);
  expectSays(missing.err, "nowhere.csv");
}

TEST_F(CompareCommand, openShowsTheReportInABrowser) {
  write("readings.csv", measurementsWith(0));
  write("browser", "#!/bin/sh\necho \"$1\" >shown.txt.new && mv shown.txt.new shown.txt\n");
  std::filesystem::permissions(folder / "browser", std::filesystem::perms::owner_all);
  ASSERT_EQ(::setenv("BROWSER", (folder / "browser").c_str(), 1), 0);
  const auto outcome = run("compare " + shipped("bench.yaml") + " readings.csv --report page.html --open");
  ASSERT_EQ(::unsetenv("BROWSER"), 0);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!std::filesystem::exists(folder / "shown.txt") && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(contentOf(folder / "shown.txt"), std::filesystem::canonical(folder / "page.html").string() + "\n");
  EXPECT_NE(run("compare " + shipped("bench.yaml") + " readings.csv --open").exit_code, 0) << "without a report";
}

/// Returns the table with the field of line `row` and column `column`, both counted from 0, replaced by `change`.
std::string withCell(const std::string& table, std::size_t row, std::size_t column,
                     const std::function<std::string(const std::string&)>& change) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < row; ++k) at = table.find('\n', at) + 1;
  for (std::size_t k = 0; k < column; ++k) at = table.find(',', at) + 1;
  const std::size_t end = table.find_first_of(",\n", at);
  return table.substr(0, at) + change(table.substr(at, end - at)) + table.substr(end);
}

// All commands treat outliers the same way: an isolated outlier is named and excluded from all results.
TEST_F(CompareCommand, anOutlierIsSetAsideAsDiagnoseDoes) {
  const auto off = [](const std::string& inches) { return fmt::format("{}", std::stod(inches) + 0.2); };
  (void)write("clean.csv", measurementsWith(0));
  (void)write("readings.csv", withCell(measurementsWith(0), 18, 8, off));
  const json clean = json::parse(run("compare " + shipped("bench.yaml") + " clean.csv --json -").out);
  EXPECT_EQ(clean["set_aside"], json::array());
  for (const char* command : {"compare", "identify", "diagnose"}) {
    const std::string free = command == std::string("identify") ? " --free tool.joint_stiffness.z" : "";
    const Outcome outcome = run(fmt::format("{} {} readings.csv{} --json -", command, shipped("bench.yaml"), free));
    EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["set_aside"], json::array({"18"})) << command;
  }
  const json without = json::parse(run("compare " + shipped("bench.yaml") + " readings.csv --json -").out);
  EXPECT_EQ(without["verdict"], "adequate");
  EXPECT_EQ(without["as_it_stands"]["readings"], 39);
  EXPECT_LT(without["as_it_stands"]["rms"], 1.1 * clean["as_it_stands"]["rms"].get<double>());
  const Outcome kept = run("compare " + shipped("bench.yaml") + " readings.csv --assume as-is --json -");
  EXPECT_EQ(kept.exit_code, 1);
  EXPECT_EQ(json::parse(kept.out)["set_aside"], json::array());
}

// A row that was logged before the controller updated the joints is reported as a mistake, and is not treated as a
// repeat of the previous row.
TEST_F(CompareCommand, aStaleRowIsNamedAndExcusesNothing) {
  std::string table = measurementsWith(0);
  std::vector<std::string> rows;
  for (std::size_t at = 0; at < table.size(); at = table.find('\n', at) + 1)
    rows.push_back(table.substr(at, table.find('\n', at) + 1 - at));
  const auto fieldOf = [](const std::string& row, std::size_t column) {
    std::size_t at = 0;
    for (std::size_t k = 0; k < column; ++k) at = row.find(',', at) + 1;
    return row.substr(at, row.find_first_of(",\n", at) - at);
  };
  for (const std::size_t column : {2u, 3u, 4u, 5u, 6u, 11u, 12u, 13u, 14u})
    table = withCell(table, 21, column, [&](const std::string&) { return fieldOf(rows[20], column); });
  (void)write("readings.csv", table);
  const Outcome outcome = run("compare " + shipped("bench.yaml") + " readings.csv --json -");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_NE(report["verdict"], "adequate");
  ASSERT_FALSE(report["checks"].empty());
  EXPECT_EQ(report["checks"][0]["name"], "stale-joints");
  EXPECT_EQ(report["checks"][0]["assume"], "without=21");
  EXPECT_EQ(run("compare " + shipped("bench.yaml") + " readings.csv --assume without=21").exit_code, 0);
}

}  // namespace
}  // namespace tubeplan::app
