// If a diagnosis finds several possible explanations, the measurements that its run sheet proposes decide between them,
// once they are filled in from the true arm and added to the earlier measurements.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/algorithm/string.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/app/program.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

class RunSheet : public ProgramTest {
 protected:
  RunSheet() : cell_(readCell((shippedCells() / "bench.yaml").string())) {
    auto backlash = deflection::makeEffect(cell_.arm, "backlash", "tool.z").effect;
    backlash.values = {0.15 * kDegree};
    cell_.arm.effects.push_back(backlash);
  }

  /// Returns the sheet with the coordinates of the true arm's tip filled in, with noise.
  std::string filled(const std::string& sheet) {
    boost::random::mt19937_64 random(5);
    boost::random::normal_distribution<double> noise(0, 0.003);
    std::vector<std::string> lines, fields;
    boost::split(lines, sheet, boost::is_any_of("\n"));
    std::string text = lines.front() + "\n";
    for (std::size_t k = 1; k < lines.size() && !lines[k].empty(); ++k) {
      boost::split(fields, lines[k], boost::is_any_of(","));
      calibration::Measurement measurement;
      measurement.load = std::stod(fields[3]) * kPound;
      measurement.q.resize(4);
      for (int j = 0; j < 4; ++j) {
        measurement.q[j] = std::stod(fields[static_cast<std::size_t>(4 + j)]) * kDegree;
        measurement.approach_directions.push_back(std::stoi(fields[static_cast<std::size_t>(12 + j)]));
      }
      const Eigen::Vector3d tip = calibration::predictMeasurement(cell_.arm, cell_.X_WB, measurement).value / kInch;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(fields[static_cast<std::size_t>(8 + axis)], "");
        fields[static_cast<std::size_t>(8 + axis)] = fmt::format("{:.6f}", tip[axis] + noise(random));
      }
      text += boost::join(fields, ",") + "\n";
    }
    return text;
  }

 private:
  Cell cell_;
};

TEST_F(RunSheet, FilledInAndGivenBackDecides) {
  const std::string diagnose = "diagnose " + shipped("bench.yaml") + " s/measurements.csv ";
  ASSERT_EQ(run("simulate " + shipped("bench.yaml") +
                " --design bench --readings 90 --seed 12 --hide backlash@tool.z:0.15deg --out s")
                .exit_code,
            0);
  const auto before = run(diagnose + "--run-sheet next.csv --json -");
  ASSERT_EQ(nlohmann::json::parse(before.out)["verdict"], "ambiguous");
  const std::string sheet = contentOf(folder / "next.csv");
  ASSERT_GT(std::count(sheet.begin(), sheet.end(), '\n'), 3);

  const auto empty = run(diagnose + "next.csv");
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_NE(empty.err.find("next.csv:2"), std::string::npos) << empty.err;

  write("next.csv", filled(sheet));
  const auto after = nlohmann::json::parse(run(diagnose + "next.csv --json -").out);
  EXPECT_EQ(after["verdict"], "explained");
  EXPECT_EQ(after["alternatives"][0][0]["effect"], "backlash");
  EXPECT_EQ(after["alternatives"][0][0]["at"], "tool.z");
}

TEST_F(RunSheet, MeasurementsOfSeveralFilesHaveIdsOfTheirOwn) {
  ASSERT_EQ(run("simulate " + shipped("bench.yaml") + " --design bench --readings 20 --seed 1 --out s").exit_code, 0);
  const auto twice = run("compare " + shipped("bench.yaml") + " s/measurements.csv s/measurements.csv");
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.err.find("an id of its own across all files"), std::string::npos) << twice.err;
}

}  // namespace
}  // namespace tubeplan::app
