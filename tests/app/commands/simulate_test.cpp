// `tubeplan simulate` writes measurements that other commands can read, and a file with the true cell, which predicts
// them; it refuses requests that cannot be simulated.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "deflection/rotation.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "planner/verification/lipschitz_distance.hpp"
#include "tests/app/program.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

using calibration::Measurement, calibration::MeasurementKind;
using Eigen::Vector3d;

class Simulate : public ProgramTest {
 protected:
  /// Simulates measurements into folder `out`, and returns them as other commands read them with this cell.
  [[nodiscard]] std::vector<Measurement> simulate(const std::string& cell, const std::string& arguments,
                                                  const std::string& out = "out") const {
    const Outcome outcome = run("simulate " + shipped(cell) + " " + arguments + " --out " + out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    if (outcome.exit_code != 0) return {};
    const Cell read = readCell((shippedCells() / cell).string());
    return readMeasurements((folder / out / "measurements.csv").string(), read.arm,
                            read.sheet ? &*read.sheet : nullptr);
  }

  [[nodiscard]] YamlNode truth(const std::string& out = "out") const {
    return readYamlFile((folder / out / "truth.yaml").string()).root;
  }

  void expectRefused(const std::string& arguments, const std::vector<std::string>& words) const {
    const Outcome outcome = run("simulate " + arguments + " --out out");
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const std::string& word : words) expectSays(outcome.err, word);
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << arguments;
  }
};

Vector3d vectorOf(const YamlNode& node, double unit) {
  Vector3d v;
  for (int k = 0; k < 3; ++k) v[k] = node.list().at(static_cast<std::size_t>(k)).number() * unit;
  return v;
}

Eigen::Isometry3d baseOf(const YamlNode& node) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() = vectorOf(node.at("position"), kInch);
  X_WB.linear() = deflection::rotationFromFixedAngles<double>(vectorOf(node.at("rpy"), kDegree));
  return X_WB;
}

TEST_F(Simulate, EveryDesignAndKindIsReadBack) {
  (void)write("distance.yaml", "kind: distance\nanchor: [100, 20, 0]\n");
  (void)write("deflection.yaml", "kind: deflection\npostures: 10\nsetups: 2\n");
  (void)write("vision.yaml", "kind: position\nat: holes\n");
  const auto bench = simulate("bench.yaml", "--design bench --readings 120");
  ASSERT_EQ(bench.size(), 120u);
  for (const auto& m : bench) {
    EXPECT_EQ(m.kind, MeasurementKind::kPosition);
    EXPECT_TRUE(m.p_W && m.approach_directions.size() == 4);
    for (const auto condition : {deflection::Condition::kTemperature, deflection::Condition::kTime})
      EXPECT_TRUE(m.conditions.states(condition));
    EXPECT_NEAR(m.sigma, 0.003 * kInch, 1e-15);
  }
  for (const auto& m : simulate("bowl.yaml", "--design bowl --readings 30"))
    EXPECT_TRUE(m.kind == MeasurementKind::kTouch && m.p_W);
  for (const int measurements : {31, 32, 33}) {
    std::map<std::string, int> touches;
    for (const auto& m : simulate("bench.yaml", fmt::format("--design touch --readings {}", measurements))) {
      EXPECT_TRUE(m.kind == MeasurementKind::kTouch && !m.p_W && !m.point.empty());
      ++touches[m.point];
    }
    int all = 0;
    for (const auto& [point, count] : touches) {
      EXPECT_GE(count, 2) << point << " of "
                          << measurements;  // a single touch of an unknown point gives no information
      all += count;
    }
    EXPECT_EQ(all, measurements);
  }
  for (const auto& m : simulate("bench.yaml", "--design distance.yaml --readings 30"))
    EXPECT_TRUE(m.kind == MeasurementKind::kDistance && m.kind_values[0] > 0);
  const auto deflections = simulate("bowl.yaml", "--design deflection.yaml");
  EXPECT_EQ(deflections.size(), 20u);
  for (const auto& m : deflections) EXPECT_TRUE(m.kind == MeasurementKind::kDeflection && !m.setup.empty());
  for (const auto& m : simulate("mockup.yaml", "--design vision.yaml --readings 10"))
    EXPECT_TRUE(m.kind == MeasurementKind::kPosition && m.load == 0 && m.p_W->z() < -0.9 * kInch);
  for (const auto& m : simulate("mockup.yaml", "--design bowl --readings 12 --loads 5,10"))
    EXPECT_TRUE(m.p_W->z() == 0 && m.point.starts_with("R")) << m.point;
}

TEST_F(Simulate, InclinometersOnRowsAreIdentifiedFrom) {
  (void)write("tilts.yaml", "kind: tilt\nrows: [base-link, forearm, tool]\npostures: 10\n");
  const auto measurements = simulate("bench.yaml", "--design tilts.yaml --seed 3");
  ASSERT_EQ(measurements.size(), 90u) << "ten postures under three loads on three rows";
  for (const auto& m : measurements) EXPECT_TRUE(m.kind == MeasurementKind::kTilt && m.row) << m.id;
  const Outcome found =
      run("identify " + shipped("bench.yaml") + " out/measurements.csv --free tool.joint_stiffness.z --json -");
  ASSERT_EQ(found.exit_code, 0) << found.err;
  const auto number = nlohmann::json::parse(found.out)["parameters"][0];
  EXPECT_LT(number["sigma"].get<double>(), 0.05 * number["value"].get<double>());
  EXPECT_NEAR(number["value"].get<double>(), 5588, 4 * number["sigma"].get<double>());
}

TEST_F(Simulate, ATrackersCorrelatedNoiseIsWrittenAndReadBack) {
  (void)write("tracker.yaml", "kind: position\nsigmas: [0.001, 0.005, 0.005]\ncorrelations: [0.5, 0.2, -0.3]\n");
  for (const auto& m : simulate("bench.yaml", "--design tracker.yaml --readings 12")) {
    ASSERT_TRUE(m.sigma_W && m.correlation_W);
    EXPECT_TRUE(m.sigma_W->isApprox(Vector3d(0.001, 0.005, 0.005) * kInch));
    EXPECT_TRUE(m.correlation_W->isApprox(Vector3d(0.5, 0.2, -0.3)));
  }
  for (const auto& m : simulate("bench.yaml", "--design tracker.yaml --readings 12 --sigma 0.002", "plain"))
    EXPECT_FALSE(m.sigma_W || m.correlation_W) << "an option goes before the design";
}

TEST_F(Simulate, TheTruthPredictsTheMeasurements) {
  const auto measurements = simulate("bowl.yaml", "--design bowl --readings 60 --spread 0.1 --sigma 0.002 --seed 5");
  const YamlNode root = truth();
  EXPECT_EQ(root.at("design").text(), "bowl");
  EXPECT_EQ(root.at("seed").number(), 5);
  EXPECT_EQ(root.at("readings").number(), 60);
  EXPECT_EQ(root.at("sigma").number(), 0.002);
  EXPECT_EQ(root.at("spread").number(), 0.1);
  EXPECT_EQ(root.at("hidden").list().size(), 0u);
  EXPECT_EQ(root.at("points").list().size(), 20u);
  ASSERT_EQ(root.at("parameters").list().size(), 6u);
  Cell cell = readCell((shippedCells() / "bowl.yaml").string());
  for (const auto& node : root.at("parameters").list()) {
    const auto parameter = deflection::findParameter(cell.arm, node.at("name").text());
    ASSERT_TRUE(parameter.has_value()) << node.at("name").text();
    const double ratio = node.at("value").number() / node.at("nominal").number();
    EXPECT_NE(ratio, 1);
    EXPECT_NEAR(std::log(ratio), 0, 0.4);
    deflection::locate(cell.arm, parameter->path) *= ratio;
  }
  const auto X_WB = baseOf(root.at("bases").list().at(0));
  EXPECT_GT(X_WB.translation().norm(), 0.01 * kInch) << "a base that is not known is off";
  double squares = 0;
  for (const auto& m : measurements) {
    const auto shape =
        deflection::solveFlexibleKinematics(cell.arm, {m.q, m.load, deflection::gravityInBase(cell.arm, X_WB)});
    squares += (X_WB * shape.X_BD.p - *m.p_W).squaredNorm() / 180;
  }
  // The expected error consists of 0.002 in of centring and of 0.002 deg in each of four joints with levers of up to 80
  // in.
  EXPECT_GT(std::sqrt(squares), 0.002 * kInch);
  EXPECT_LT(std::sqrt(squares), 0.005 * kInch);
}

TEST_F(Simulate, AKnownBaseIsWhereTheCellHasIt) {
  (void)simulate("bench.yaml", "--design bench --readings 3");
  const auto X_WB = baseOf(truth().at("bases").list().at(0));
  EXPECT_EQ(X_WB.matrix(), Eigen::Isometry3d::Identity().matrix());
  EXPECT_EQ(truth().at("points").list().size(), 0u);
}

TEST_F(Simulate, TheSameSeedGivesTheSameBytesAndAnotherDoesNot) {
  for (const std::string arguments : {"bowl.yaml --spread 0.1 --held-out 0.3", "mockup.yaml --base-error 0.2,0.3"}) {
    const std::string cell = arguments.substr(0, arguments.find(' '));
    const std::string options = arguments.substr(cell.size()) + " --design bowl --readings 30 --seed ";
    (void)simulate(cell, options + "4", "one");
    (void)simulate(cell, options + "4", "two");
    (void)simulate(cell, options + "5", "other");
    for (const char* file : {"measurements.csv", "truth.yaml"}) {
      EXPECT_EQ(contentOf(folder / "one" / file), contentOf(folder / "two" / file)) << file;
      EXPECT_NE(contentOf(folder / "one" / file), contentOf(folder / "other" / file)) << file;
    }
  }
}

TEST_F(Simulate, PosturesKeepClearOfTheScene) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  for (const std::string design : {"bench", "touch", "bowl"}) {
    const auto measurements = simulate("mockup.yaml", "--design " + design + " --readings 60");
    ASSERT_EQ(measurements.size(), 60u);
    planner::Workcell work;
    work.arm = cell.arm;
    work.X_WB = baseOf(truth().at("bases").list().at(0));
    work.scene = cell.scene;
    // Only in touches of holes may the tool be in the sheet.
    if (design != "bowl")
      for (auto& obstacle : work.scene.obstacles) std::erase(obstacle.allow, "tool-tip");
    for (const auto& m : measurements) {
      work.load = m.load;
      const auto frames = planner::bodyFrames(work, m.q, nullptr);
      std::string names;
      const double margin = planner::LipschitzMargins(work.scene).at(frames, 1e-5, 0.01, &names);
      // The margin may fall short by five sigmas of the encoder noise at a lever of 80 in, and by no more.
      EXPECT_GE(margin, -5 * 0.002 * kDegree * 80 * kInch) << design << " " << m.id << " " << names;
    }
  }
}

TEST_F(Simulate, HoldsOutAShareOfThePoints) {
  const auto measurements = simulate("bench.yaml", "--design bench --readings 60 --held-out 0.25");
  EXPECT_EQ(std::count_if(measurements.begin(), measurements.end(), [](const auto& m) { return m.is_held_out; }), 15);
}

TEST_F(Simulate, CalibrateFindsTheBase) {
  (void)simulate("mockup.yaml", "--design bowl --readings 12 --loads 0");
  const Outcome outcome = run("calibrate " + shipped("mockup.yaml") + " out/measurements.csv --out found.yaml");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  (void)write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
  const auto found = readYamlFile((folder / "found.yaml").string()).root;
  const auto X_WB = baseOf(truth().at("bases").list().at(0));
  EXPECT_LE((vectorOf(found.at("base").at("position"), kInch) - X_WB.translation()).norm(), 0.02 * kInch);
}

TEST_F(Simulate, RefusesCampaignsThatCannotBe) {
  const std::string bench = shipped("bench.yaml") + " --design bench";
  expectRefused(shipped("bench.yaml") + " --design benhc --readings 9",
                {"--design", "'benhc'", "did you mean 'bench'?"});
  expectRefused(shipped("bench.yaml") + " --design none.yaml --readings 9", {"none.yaml", "no such file"});
  expectRefused(bench, {"--readings", "nothing", "add --readings N"});
  for (const char* count : {"0", "-3", "100001"}) expectRefused(bench + " --readings " + count, {"--readings", count});
  expectRefused(bench + " --readings 99999999999999", {"--readings"});
  expectRefused(bench + " --readings 9 --loads 0,-20", {"--loads", "-20", "lbf"});
  expectRefused(bench + " --readings 9 --sigma -0.1", {"--sigma", "-0.1"});
  expectRefused(bench + " --readings 9 --sigma nan", {"--sigma", "nan"});
  expectRefused(bench + " --readings 9 --spread -0.1", {"--spread", "-0.1"});
  expectRefused(shipped("mockup.yaml") + " --design bench --readings 9 --spread 0.1", {"mockup.yaml", "identify"});
  expectRefused(bench + " --readings 9 --held-out 1", {"--held-out", "below 1"});
  expectRefused(bench + " --readings 3 --held-out 0.5", {"a single point or posture cannot be held out"});
  expectRefused(bench + " --readings 9 --base-error 1,1", {"--base-error", "known: false"});
  expectRefused(shipped("bowl.yaml") + " --design bowl --readings 9 --base-error 1", {"--base-error", "two"});
  expectRefused(shipped("bench.yaml") + " --design touch --readings 9 --loads 20", {"touched only once"});
  (void)write("holes.yaml", "kind: position\nat: holes\n");
  expectRefused(shipped("bench.yaml") + " --design holes.yaml --readings 9", {"bench.yaml", "tubesheet"});
  expectRefused(shipped("mockup.yaml") + " --design holes.yaml --readings 9 --loads 10", {"observed under a load"});
  (void)write("setups.yaml", "kind: position\nsetups: 2\n");
  expectRefused(shipped("bench.yaml") + " --design setups.yaml --readings 9", {"2 set-ups", "known: false"});
}

TEST_F(Simulate, WritesOverNoMeasurementsButItsOwn) {
  std::filesystem::create_directories(folder / "real");
  (void)write("real/measurements.csv", "of a robot\n");
  const std::string made = "simulate " + shipped("bench.yaml") + " --design bench --readings 5 --out ";
  const Outcome outcome = run(made + "real");
  EXPECT_EQ(outcome.exit_code, 2);
  expectSays(outcome.err, "measurements.csv was not written by an earlier run of this command");
  EXPECT_EQ(contentOf(folder / "real/measurements.csv"), "of a robot\n");
  EXPECT_EQ(run(made + "own").exit_code, 0);
  EXPECT_EQ(run(made + "own --seed 2").exit_code, 0);
}

TEST_F(Simulate, SaysWhyNothingIsInReachAndLeavesNothing) {
  (void)write("far.yaml", "kind: position\nregion: {from: [900, 0, 0], to: [901, 1, 1]}\n");
  const Outcome outcome = run("simulate " + shipped("bench.yaml") + " --design far.yaml --readings 9 --out out");
  EXPECT_EQ(outcome.exit_code, 1);
  expectSays(outcome.err, "no campaign");
  expectSays(outcome.err, "outside the region");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace tubeplan::app
