// `tubeplan improve` writes the model that it reports, states why it ended, and writes nothing if the measurements
// allow no verdict. The arguments for `add` that a diagnosis prints add the effect that it found.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/formats/cell/cell_reader.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class Improve : public ProgramTest {
 protected:
  [[nodiscard]] std::string bench() const { return shipped("bench.yaml"); }

  void simulate(const std::string& hide, int measurements = 120, int seed = 7) {
    const auto outcome =
        run("simulate " + bench() + " --design bench --readings " + std::to_string(measurements) + " --seed " +
            std::to_string(seed) + " --spread 0.1 --out set" + (hide.empty() ? "" : " --hide '" + hide + "'"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  /// Adds `by` to the x coordinate of the measurement on line `line` of the table, counted from 0.
  static void shiftCoordinate(std::string& text, int line, double by) {
    std::vector<std::string> lines, fields;
    std::istringstream all(text), header(text.substr(0, text.find('\n')));
    for (std::string one; std::getline(all, one);) lines.push_back(one);
    for (std::string one; std::getline(header, one, ',');) fields.push_back(one);
    const auto column = static_cast<std::size_t>(
        std::find_if(fields.begin(), fields.end(), [](const auto& name) { return name.starts_with("x_"); }) -
        fields.begin());
    std::string& changed = lines.at(static_cast<std::size_t>(line));
    std::size_t from = 0;
    for (std::size_t k = 0; k < column; ++k) from = changed.find(',', from) + 1;
    const std::size_t end = changed.find(',', from);
    changed.replace(from, end - from, std::to_string(std::stod(changed.substr(from, end - from)) + by));
    text.clear();
    for (const auto& one : lines) text += one + "\n";
  }

  [[nodiscard]] json improved(const std::string& more = "") {
    const auto outcome = run("improve " + bench() + " set/measurements.csv --out new.yaml --json figures.json" + more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(contentOf(folder / "figures.json"));
  }
};

TEST_F(Improve, WritesTheModelThatItReports) {
  simulate("hysteresis@theta4:0.06deg");
  const json figures = improved();
  EXPECT_EQ(figures["end"], "adequate");
  ASSERT_EQ(figures["models"].size(), 2U);
  EXPECT_EQ(figures["steps"][0]["added"], json({"hysteresis@theta4"}));
  EXPECT_LT(figures["steps"][0]["farthest_rms"]["after"], figures["steps"][0]["farthest_rms"]["before"]);
  const auto compared = run("compare new.yaml set/measurements.csv --json -");
  const double reported = figures["models"][1]["rms"]["fitted"];
  EXPECT_NEAR(json::parse(compared.out)["rms"]["before"].get<double>(), reported, 0.01 * reported);
}

/// A measurement that is set aside is named, and enters neither the fit nor the reported errors.
TEST_F(Improve, FitsWithoutWhatItSetsAside) {
  simulate("hysteresis@theta4:0.06deg");
  std::string text = contentOf(folder / "set/measurements.csv");
  shiftCoordinate(text, 40, 1.5);
  write("set/measurements.csv", text);
  const json figures = improved();
  EXPECT_EQ(figures["end"], "adequate") << figures.dump(1);
  ASSERT_EQ(figures["set_aside"].size(), 1U);
  ASSERT_EQ(figures["models"].size(), 2U);
  const auto& last = figures["models"][1];
  EXPECT_LT(last["rms"]["fitted"].get<double>(), 1.3 * last["rms"]["noise_floor"].get<double>());
  const auto without = run("compare new.yaml set/measurements.csv --json - --assume without=" +
                           figures["set_aside"][0].get<std::string>());
  const double reported = last["rms"]["fitted"];
  EXPECT_NEAR(json::parse(without.out)["rms"]["before"].get<double>(), reported, 0.01 * reported);
}

TEST_F(Improve, SaysWhyItEndsWhereStepsRunOut) {
  simulate("encoder-eccentricity@theta3:sine=0.05,cosine=0.08");
  const json figures = improved(" --steps 1");
  EXPECT_EQ(figures["end"], "most-steps");
  EXPECT_EQ(figures["steps"].size(), 1U);
}

TEST_F(Improve, WritesNothingWhereNoVerdictIsPossible) {
  simulate("joint-offset@theta3:90deg", 2, 1);
  const auto outcome = run("improve " + bench() + " set/measurements.csv --out new.yaml");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "new.yaml"));
  EXPECT_NE(outcome.out.find("nothing was written"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
}

/// An effect that is added with the arguments from the diagnosis, such as the time of a slip, reduces the error as the
/// diagnosis predicts.
TEST_F(Improve, WhatADiagnosisGivesToAddKeepsItsPromise) {
  for (const std::string hidden :
       {"base-slip@base:time=100,x=0.03,yaw=0.02", "stiffening@tool.z:softness=5,knee=200"}) {
    simulate(hidden, 150);
    const auto diagnosed = run("diagnose " + bench() + " set/measurements.csv --json -");
    ASSERT_EQ(diagnosed.exit_code, 0) << diagnosed.err;
    const json answer = json::parse(diagnosed.out);
    ASSERT_FALSE(answer["alternatives"].empty()) << hidden << answer["sentence"];
    std::string causes;
    for (const auto& effect : answer["alternatives"][0]) causes += " '" + effect["add"].get<std::string>() + "'";
    ASSERT_EQ(run("add " + bench() + causes + " --out with.yaml").exit_code, 0) << causes;
    const auto fitted = run("identify with.yaml set/measurements.csv --json -");
    ASSERT_EQ(fitted.exit_code, 0) << fitted.err;
    const double promised = answer["rms"]["heldout_after"];
    EXPECT_NEAR(json::parse(fitted.out)["rms"]["heldout_after"].get<double>(), promised, 0.05 * promised) << causes;
  }
}

TEST_F(Improve, AddTakesNumbersOfTheFileAndEffectsAtAllJoints) {
  ASSERT_EQ(run("add " + bench() + " 'joint-compliance@all joints' free@geometry --out with.yaml").exit_code, 0);
  const Cell cell = readCell((folder / "with.yaml").string());
  EXPECT_GE(cell.arm.effects.size(), 2U);
  EXPECT_NE(std::find(cell.identify.begin(), cell.identify.end(), "geometry"), cell.identify.end());
  const auto refused = run("add " + bench() + " free@gremlin --out other.yaml");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("gremlin"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace tubeplan::app
