// `touches` proposes measurements that reduce the uncertainty as predicted, and `sensitivity` ranks the parameters of
// an arm.
#include "app/jobs/touches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/documents/touch_outcome.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/jobs/calibration.hpp"
#include "calibration/design/touch_reserve.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "tests/app/program.hpp"
#include "tests/app/test_files.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class LookAhead : public ProgramTest {
 protected:
  [[nodiscard]] json jsonOf(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  void expectRefused(const std::string& arguments, const std::vector<std::string>& words) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    for (const std::string& word : words) expectSays(outcome.err, word);
  }
};

class SmallSheet : public LookAhead {
 protected:
  /// Writes small.yaml, the mock-up with a sheet of `rows` rows of 30 holes each.
  void writeSheet(int rows) const {
    std::string map = "row,column,x_in,y_in\n";
    for (int row = 1; row <= rows; ++row)
      for (int column = 1; column <= 30; ++column)
        map += fmt::format("{},{},{},{}\n", row, column, 1.0625 * (column - 15), 20 + 1.0625 * row);
    writeMappedMockup("small.yaml", map);
  }
};

TEST_F(SmallSheet, IsWorkedOnWithoutNamingTubes) {
  writeSheet(1);
  const Outcome proposed = run("touches small.yaml");
  EXPECT_EQ(proposed.exit_code, 1) << proposed.err;
  expectSays(proposed.out, "the touched holes lie nearly on a line");
  writeSheet(3);
  EXPECT_EQ(run("sensitivity small.yaml --json s.json").exit_code, 0);
  EXPECT_EQ(run("campaign small.yaml --runs 3 --json c.json").exit_code, 0);
}

TEST_F(LookAhead, touchesPlacesTheBaseOfTheMockUp) {
  const json found = jsonOf("touches " + shipped("mockup.yaml") + " --tubes spread:12 --candidates 14");
  ASSERT_EQ(found["next_readings"].size(), 3u);
  std::vector<std::array<double, 2>> at;
  for (const auto& touch : found["next_readings"]) {
    EXPECT_EQ(touch["kind"], "touch");
    EXPECT_EQ(touch["for"], "base");
    EXPECT_EQ(touch["joints"].size(), 4u);
    at.push_back({touch["place"][0], touch["place"][1]});
  }
  // The three touches are far from collinear: their triangle is high compared with its longest side.
  const double area =
      std::abs((at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) - (at[2][0] - at[0][0]) * (at[1][1] - at[0][1]));
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const auto &a = at[static_cast<std::size_t>(k)], &b = at[static_cast<std::size_t>((k + 1) % 3)];
    longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  EXPECT_GT(area / (longest * longest), 0.2);
  const json& sigma = found["base"]["tip_sigma"];
  EXPECT_LT(sigma["after"]["rms"], sigma["random"]["rms"]);
  EXPECT_LT(sigma["after"]["rms"].get<double>(), 0.1 * sigma["nearest"]["rms"].get<double>());
  EXPECT_GT(sigma["now"]["rms"].get<double>(), 1);
  EXPECT_EQ(found["base"]["nearest_holes"].size(), 3u);
  EXPECT_EQ(found["units"]["length"], "in");
}

/// A hole that is within reach only from the nominal base is not proposed as a touch for calibrating the base.
TEST_F(LookAhead, touchesForTheBaseAreInReachWhereItStandsOtherwise) {
  TouchRequest request;
  request.cell = (shippedCells() / "mockup.yaml").string();
  request.tubes = "spread:12";
  const TouchOutcome found = proposeTouches(request);
  const planner::Workcell cell = workcellOf(found.cell, "test");
  std::vector<calibration::TouchPlan> plans;
  for (const auto& step : found.base.value().next.design.steps) {
    const auto& measurement = found.base->chosen(step).measurements.front();
    plans.push_back({measurement.point, measurement.point, measurement.known_W.value(), measurement.q});
  }
  ASSERT_EQ(plans.size(), 3U);
  EXPECT_EQ(calibration::keepTouchable(cell.arm, cell.X_WB, plans).size(), 3U);
  EXPECT_TRUE(std::ranges::any_of(found.notes, [](const auto& note) { return note.find("excluded") != note.npos; }));
}

/// For different arms, the predicted sigmas agree with those that `calibrate` states for touches of the proposed holes.
TEST_F(LookAhead, touchesForetellsWhatCalibrateStates) {
  for (const char* name : {"mockup.yaml", "puma.yaml", "column.yaml"}) {
    TouchRequest request;
    request.cell = (shippedCells() / name).string();
    request.tubes = "spread:12";
    request.candidates = 14;
    request.goal = "base";
    const TouchOutcome found = proposeTouches(request);
    std::vector<calibration::TouchPlan> plans;
    for (const auto& step : found.base.value().next.design.steps) {
      const auto& measurement = found.base->chosen(step).measurements.front();
      plans.push_back({measurement.point, measurement.point, measurement.known_W.value(), measurement.q});
    }
    calibration::TouchSimulationOptions simulation;
    simulation.sigma = found.base_noise.sigma;
    calibration::BaseStep off;
    off << 0.002, -0.003, 0.001, 0.001, 0.0005, -0.001;
    const auto touches =
        calibration::simulateTouches(found.cell.arm, calibration::moved(found.cell.X_WB, off), plans, simulation)
            .touches;
    const auto stated = calibrateCell(found.cell, touches, "simulated").calibration;
    ASSERT_EQ(stated.status, calibration::CalibrationStatus::kDone) << name << stated.reason;
    ASSERT_EQ(stated.model_error, 0) << name;
    ASSERT_EQ(found.base->next.numbers.size(), 6U) << name;
    for (Eigen::Index k = 0; k < 6; ++k) {
      const double sigma = std::sqrt(stated.covariance(k, k));
      EXPECT_NEAR(found.base->next.numbers[static_cast<std::size_t>(k)].after, sigma, 0.05 * sigma) << name << k;
    }
  }
}

/// Returns the run sheet filled in with the predicted joint values of its `near_` columns.
std::string touchedAsForeseen(const std::string& sheet) {
  const auto table = tubesheets::parseCsv(sheet);
  std::string text = sheet.substr(0, sheet.find('\n') + 1);
  for (const auto& row : table.rows) {
    std::string line;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const auto near = table.find("near_" + table.columns[c]);
      line += (c ? "," : "") + (near ? row.fields[*near] : row.fields[c]);
    }
    text += line + "\n";
  }
  return text;
}

TEST_F(LookAhead, touchesAddsToTheTouchesMadeAlready) {
  const json first = jsonOf("touches " + shipped("mockup.yaml") + " --tubes spread:12 --candidates 14 --csv next.csv");
  const Outcome untouched = run("calibrate " + shipped("mockup.yaml") + " next.csv --out found.yaml");
  EXPECT_EQ(untouched.exit_code, 2);
  expectSays(untouched.err, "3 readings are not filled in: T1 in line 2, T2 in line 3, T3 in line 4");
  EXPECT_FALSE(std::filesystem::exists(folder / "found.yaml"));
  (void)write("next.csv", touchedAsForeseen(contentOf(folder / "next.csv")));
  const json second =
      jsonOf("touches " + shipped("mockup.yaml") + " --tubes spread:12 --candidates 14 --readings next.csv");
  EXPECT_NEAR(second["base"]["tip_sigma"]["now"]["rms"].get<double>(),
              first["base"]["tip_sigma"]["after"]["rms"].get<double>(), 1e-4);
  EXPECT_LT(second["base"]["tip_sigma"]["after"]["rms"], second["base"]["tip_sigma"]["now"]["rms"]);
  EXPECT_EQ(second["base"]["sigma_from"], "the readings");
}

TEST_F(LookAhead, touchesSharpensTheStiffnessesOfTheBench) {
  const json found =
      jsonOf("touches " + shipped("bench.yaml") + " --loads 0,20,40 --count 6 --candidates 80 --csv next.csv --seed 4");
  const json& parameters = found["parameters"];
  EXPECT_EQ(parameters["numbers"].size(), 6u);
  EXPECT_EQ(parameters["candidates"], 240);
  EXPECT_LT(parameters["tip_sigma"]["after"]["worst"], parameters["tip_sigma"]["random"]["worst"]);
  EXPECT_LT(parameters["tip_sigma"]["random"]["worst"], parameters["tip_sigma"]["now"]["worst"]);
  EXPECT_GT(parameters["bits"]["after"], parameters["bits"]["random"]);
  for (const auto& number : parameters["numbers"]) EXPECT_LT(number["sigma"]["after"], number["sigma"]["now"]);
  double bits = 0;
  for (const auto& measurement : found["next_readings"]) {
    EXPECT_TRUE(measurement["load"] == 0 || measurement["load"] == 20 || measurement["load"] == 40)
        << measurement["load"];
    bits += measurement["adds"]["bits"].get<double>();
  }
  EXPECT_NEAR(bits, parameters["bits"]["after"].get<double>(), 1e-9 * bits);
  const std::string csv = contentOf(folder / "next.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "id,kind,point,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  const Outcome unfilled = run("identify " + shipped("bench.yaml") + " next.csv");
  EXPECT_EQ(unfilled.exit_code, 2);
  expectSays(unfilled.err, "6 readings are not filled in");
  expectSays(unfilled.err, "fill in the measured values, x_in, y_in, z_in");
}

TEST_F(LookAhead, touchesOfUnknownPointsCarryEveryLoad) {
  const json found =
      jsonOf("touches " + shipped("bench.yaml") + " --kind touch --loads 0,30 --count 2 --candidates 20");
  ASSERT_EQ(found["next_readings"].size(), 4u);
  for (int k = 0; k < 4; k += 2) {
    const auto &bare = found["next_readings"][k], &loaded = found["next_readings"][k + 1];
    EXPECT_EQ(bare["point"], loaded["point"]);
    EXPECT_EQ(bare["load"], 0);
    EXPECT_EQ(loaded["load"], 30);
    EXPECT_NE(bare["joints"], loaded["joints"]);
  }
  expectRefused("touches " + shipped("bench.yaml") + " --kind touch --count 2", {"--loads", "two or more"});
}

TEST_F(LookAhead, touchesServesBaseAndParametersTogether) {
  const json found = jsonOf("touches " + shipped("mockup.yaml") +
                            " --free latch-link.beam.Iz --loads 0,20 --tubes spread:8 --candidates 8 --count 4");
  ASSERT_EQ(found["next_readings"].size(), 8u);
  EXPECT_EQ(found["next_readings"][0]["for"], "base");
  EXPECT_EQ(found["next_readings"][7]["for"], "parameters");
  EXPECT_EQ(found["parameters"]["numbers"].size(), 7u);
  EXPECT_TRUE(found["parameters"]["numbers"][6]["identifiable"]["after"]);
}

TEST_F(LookAhead, theSameSeedGivesTheSameBytes) {
  const std::string command = "touches " + shipped("bench.yaml") + " --candidates 40 --count 3 --json ";
  ASSERT_EQ(run(command + "one.json --seed 5").exit_code, 0);
  ASSERT_EQ(run(command + "two.json --seed 5").exit_code, 0);
  ASSERT_EQ(run(command + "three.json --seed 6").exit_code, 0);
  EXPECT_EQ(contentOf(folder / "one.json"), contentOf(folder / "two.json"));
  EXPECT_NE(contentOf(folder / "one.json"), contentOf(folder / "three.json"));
}

TEST_F(LookAhead, touchesRefusesWhatMakesNoSense) {
  const std::string bench = "touches " + shipped("bench.yaml"), mockup = "touches " + shipped("mockup.yaml");
  expectRefused(bench + " --free forearm.dh.aa", {"--free", "forearm.dh.aa", "did you mean"});
  expectRefused(bench + " --goal base", {"tubesheet"});
  expectRefused(bench + " --tubes R1C1", {"tubesheet"});
  expectRefused(bench + " --loads=-5", {"--loads", "zero or more"});
  expectRefused(bench + " --sigma=-1", {"--sigma", "-1", "above zero"});
  expectRefused(bench + " --sigma 0", {"--sigma", "above zero"});
  expectRefused(bench + " --readings none.csv", {"none.csv"});
  expectRefused(bench + " --optimal Q", {"--optimal"});
  expectRefused(mockup + " --count 2", {"--count", "three or more"});
  expectRefused(mockup + " --tubes R99C1", {"--tubes"});
}

TEST_F(LookAhead, workOutOfReachIsANegativeAnswer) {
  for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  (void)write("far.yaml",
              changed(contentOf(folder / "mockup.yaml"), "position: [0, 43.0, -44.0]", "position: [0, 43.0, -440]"));
  const Outcome outcome = run("touches far.yaml --tubes spread:5");
  EXPECT_EQ(outcome.exit_code, 1);
  expectSays(outcome.out, "no tube of the work list can be reached");
  const Outcome sensitivity = run("sensitivity far.yaml --tubes spread:5");
  EXPECT_EQ(sensitivity.exit_code, 1);
  EXPECT_NE(sensitivity.err, "");
}

TEST_F(LookAhead, tooFewCandidatesAreANegativeAnswer) {
  const Outcome outcome = run("touches " + shipped("bench.yaml") + " --candidates 3 --count 5 --csv next.csv");
  EXPECT_EQ(outcome.exit_code, 1);
  expectSays(outcome.out, "3 readings can be made, but 5 are asked for");
  EXPECT_FALSE(std::filesystem::exists(folder / "next.csv"));
}

TEST_F(LookAhead, sensitivityRanksTheMembersOfTheMockUp) {
  const json found = jsonOf("sensitivity " + shipped("mockup.yaml") + " --tubes spread:10");
  EXPECT_EQ(found["touches"].size(), 3u);
  EXPECT_GT(found["mean_deflection"], 0.2);
  EXPECT_LT(found["mean_uncompensated_error"], found["mean_deflection"]);
  ASSERT_GT(found["design"].size(), 15u);
  double before = 1e9;
  for (const auto& number : found["design"]) {
    const double now = std::abs(number["deflection_per_percent"].get<double>());
    EXPECT_LE(now, before);
    before = now;
    const std::string sentence = number["sentence"];
    expectSays(sentence, "less deflection on average");
    if (number["kind"] == "stiffness") expectSays(sentence, "1 % stiffer");
    if (number["kind"] == "weight") expectSays(sentence, "1 % lighter");
  }
  before = 1e9;
  for (const auto& number : found["knowledge"]) {
    EXPECT_LE(number["error_per_percent"], before);
    before = number["error_per_percent"];
  }
}

// The change of deflection predicted for 1 % agrees with the change when a moment of inertia in the arm file is raised
// by 1 %.
TEST_F(LookAhead, sensitivityForetellsWhatAChangedArmDoes) {
  for (const char* name : {"bench.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  const json found = jsonOf("sensitivity bench.yaml --load 20");
  (void)write("cobra-arm.yaml", changed(contentOf(folder / "cobra-arm.yaml"), "Iz: 0.394", "Iz: 0.39794"));
  const json stiffer = jsonOf("sensitivity bench.yaml --load 20");
  const double change = stiffer["mean_deflection"].get<double>() - found["mean_deflection"].get<double>();
  for (const auto& number : found["design"]) {
    if (number["name"] != "latch-link.beam.Iz") continue;
    EXPECT_NEAR(number["deflection_per_percent"], change, 0.015 * std::abs(change));
  }
  EXPECT_EQ(found["touches"].size(), 0u);
  EXPECT_EQ(found["work"]["postures"], 60);
}

TEST_F(LookAhead, measurementsSayHowFarEachNumberMayBeOff) {
  std::string csv = "id,kind,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in\n";
  int id = 0;
  for (const char* joints : {"-30,40,-30,-10", "80,120,-90,-30", "10,20,10,5", "150,60,-40,20", "-100,90,30,60"})
    for (const int load : {0, 20, 40}) {
      const json tip = jsonOf("pose " + shipped("bench.yaml") + " --joints=" + joints + " --load " +
                              std::to_string(load))["flexible"];
      csv += std::to_string(++id) + ",position," + std::to_string(load) + "," + joints;
      // Adds errors about as large as the stated sigma, because a fit that is too good would be reported as a mistake.
      for (int k = 0; k < 3; ++k)
        csv += "," + std::to_string(tip["position"][k].get<double>() + 0.004 * std::sin(7 * id + 3 * k));
      csv += ",0.003\n";
    }
  (void)write("readings.csv", csv);
  const json ahead = jsonOf("touches " + shipped("bench.yaml") + " --readings readings.csv --candidates 20 --count 2");
  const json found = jsonOf("sensitivity " + shipped("bench.yaml") + " --readings readings.csv");
  std::map<std::string, double> sigma;
  for (const auto& number : ahead["parameters"]["numbers"]) sigma[number["name"]] = number["sigma"]["now"];
  // Positions with a sigma of 0.003 in at fifteen postures determine the tool's stiffness of 5588 to within a tenth.
  EXPECT_LT(sigma.at("tool.joint_stiffness.z"), 560);
  int seen = 0;
  for (const auto& number : found["knowledge"]) {
    if (number["sigma"].is_null()) continue;
    ++seen;
    EXPECT_NEAR(number["sigma"], sigma.at(number["name"]), 1e-6 * number["sigma"].get<double>());
    EXPECT_NEAR(number["error_per_sigma"].get<double>() * number["value"].get<double>() / 100,
                number["error_per_percent"].get<double>() * number["sigma"].get<double>(),
                1e-6 * number["error_per_percent"].get<double>() * number["sigma"].get<double>());
  }
  EXPECT_EQ(seen, 6);
}

TEST_F(LookAhead, sensitivityRefusesWhatMakesNoSense) {
  expectRefused("sensitivity " + shipped("bench.yaml") + " --tubes R1C1", {"tubesheet"});
  expectRefused("sensitivity " + shipped("bench.yaml") + " --load=-1", {"--load"});
  expectRefused("sensitivity " + shipped("bench.yaml") + " --readings none.csv", {"none.csv"});
}

}  // namespace
}  // namespace tubeplan::app
