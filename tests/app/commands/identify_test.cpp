// `tubeplan identify` finds the true parameters, writes a cell that predicts the same, refuses wrong input, and warns
// of mistakes in the measurements.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "calibration/estimation/held_out.hpp"
#include "tests/app/formats/measurements/measurements_csv.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using calibration::Measurement, calibration::MeasurementKind, calibration::PlacedArm, calibration::MeasurementMaker;
using nlohmann::json;

const std::string kFree = " --free tool.joint_stiffness.z,latch-link.beam.Iz --folds 0";

/// Returns the shipped arm with two altered stiffnesses, on the bench.
PlacedArm trueArm() {
  PlacedArm truth{deflection::cobraArm(), {{"", Eigen::Isometry3d::Identity(), true}}};
  truth.arm.rows[5].joint_stiffness.z() *= 0.8;
  truth.arm.rows[3].beam->I.z() *= 1.15;
  return truth;
}
PlacedArm movedArm() {
  PlacedArm truth = trueArm();
  truth.base_poses[0].X_WB = calibration::poseOf({0.05, -0.03, 0.02}, {0.01, -0.02, 0.05});
  return truth;
}

class Identify : public ProgramTest {
 protected:
  Identify() : maker(trueArm(), 31, MeasurementMaker::Noise::kStated) {}

  [[nodiscard]] json identified(const std::string& arguments) const {
    const Outcome outcome = run("identify " + arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Expects that `identify` is refused as bad input: exit code 2, one line of error with all of `words`, nothing on
  /// standard output, and no new file.
  void expectRefused(const std::string& arguments, const std::vector<std::string>& words) const {
    const Outcome outcome = run("identify " + arguments + " --json - --out found.yaml");
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.out;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const std::string& word : words) expectSays(outcome.err, word);
    EXPECT_FALSE(std::filesystem::exists(folder / "found.yaml"));
  }

  void writeMeasurements(const std::string& name) const { write(name, measurementsCsv(maker.measurements)); }

  /// Expects at least one warning that contains these words.
  static void expectWarns(const json& result, const std::string& words) {
    const auto& warnings = result["warnings"];
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                            [&](const json& w) { return w.get<std::string>().find(words) != std::string::npos; }))
        << warnings << "\nwithout: " << words;
  }

  MeasurementMaker maker;
};

void expectTruth(const json& result, const PlacedArm& truth) {
  const double scale[] = {kInch * kPound / kDegree, std::pow(kInch, 4)};
  const double values[] = {truth.arm.rows[5].joint_stiffness.z() / scale[0], truth.arm.rows[3].beam->I.z() / scale[1]};
  const char* units[] = {"lbf*in/deg", "in^4"};
  ASSERT_EQ(result["parameters"].size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const json& number = result["parameters"][k];
    EXPECT_NEAR(number["value"], values[k], 4 * number["sigma"].get<double>()) << number;
    EXPECT_LT(number["sigma"], 0.2 * values[k]);
    EXPECT_EQ(number["unit"], units[k]);
    EXPECT_EQ(number["identifiable"], "yes");
    EXPECT_LT(number["interval"][0], number["value"]);
    EXPECT_GT(number["interval"][1], number["value"]);
  }
  EXPECT_EQ(result["parameters"][0]["start"], 5588);
}

TEST_F(Identify, FindsTheTruthFromSmallFilesOfEachKind) {
  const auto check = [&](const std::string& name) {
    SCOPED_TRACE(name);
    writeMeasurements(name);
    const json result = identified(shipped("bench.yaml") + " " + name + kFree);
    expectTruth(result, trueArm());
    EXPECT_LT(result["rms"]["after"], result["rms"]["before"]);
    EXPECT_GT(result["p_value"], 1e-3);
    EXPECT_TRUE(result["warnings"].empty()) << result["warnings"];
    EXPECT_TRUE(result["outliers"].empty()) << result["outliers"];
    maker.measurements.clear();
  };
  maker.add(MeasurementKind::kPosition, 10);
  check("position.csv");
  maker.add(MeasurementKind::kDeflection, 10);
  check("deflection.csv");
  maker.add(MeasurementKind::kDistance, 24);
  check("distance.csv");
  maker.addTouches(6, {0, 25 * kPound}, true);
  check("touch.csv");
  maker.addTouches(6, {0, 20 * kPound, 40 * kPound}, false);
  check("unknown-points.csv");
  calibration::addEveryKind(maker, 3);
  check("mixed.csv");
}

TEST_F(Identify, WritesACellAndArmThatPredictTheSame) {
  maker = MeasurementMaker(movedArm(), 32, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 14);
  writeMeasurements("readings.csv");
  const json found = identified(shipped("bowl.yaml") + " readings.csv --out made/found.yaml" + kFree);
  expectTruth(found, movedArm());
  const Cell cell = readCell((folder / "made/found.yaml").string());
  EXPECT_EQ(std::filesystem::path(cell.arm_path).filename(), "found-arm.yaml");
  expectSays(contentOf(folder / "made/found-arm.yaml"), "# The Cobra arm on its mezzanine");
  EXPECT_TRUE(cell.base_covariance.has_value());
  const auto measurements = readMeasurements((folder / "readings.csv").string(), cell.arm);
  const PlacedArm placed{cell.arm, {{"", cell.X_WB, true}}};
  EXPECT_NEAR(calibration::judge(placed, measurements).rms / kInch, found["rms"]["after"], 1e-6);
  const json again = identified("made/found.yaml readings.csv" + kFree);
  EXPECT_NEAR(again["rms"]["before"], found["rms"]["after"], 1e-6);
  const json &one = found["parameters"][0], &two = again["parameters"][0];
  EXPECT_NEAR(two["value"], one["value"], 0.01 * one["sigma"].get<double>()) << "weights rest to a thousandth only";
  const std::string pose = "pose made/found.yaml --joints=20,70,-60,-20 --load 20 --json -";
  EXPECT_EQ(run(pose).exit_code, 0);
}

TEST_F(Identify, TheSameMeasurementsGiveTheSameBytes) {
  calibration::addEveryKind(maker, 3);
  writeMeasurements("readings.csv");
  const std::string call =
      "identify " + shipped("bench.yaml") +
      " readings.csv --free tool.joint_stiffness.z,latch-link.beam.Iz --folds 3 --starts 2 --seed 4 --json -";
  EXPECT_EQ(run(call).out, run(call).out);
}

// Option -v only adds the iterations to the output; with --json - the iterations go to standard error.
TEST_F(Identify, PrintsItsIterationsWhereThatIsAskedFor) {
  maker.add(MeasurementKind::kPosition, 12);
  writeMeasurements("readings.csv");
  const std::string arguments = "identify " + shipped("bench.yaml") + " readings.csv" + kFree;
  const Outcome plain = run(arguments), verbose = run(arguments + " -v"), as_json = run(arguments + " -v --json -");
  EXPECT_EQ(plain.out.find("iteration"), std::string::npos);
  expectSays(verbose.out, "levenberg-marquardt\n  iteration      chi-square         step      damping\n          0 ");
  EXPECT_EQ(verbose.out.substr(verbose.out.find("errors of")), plain.out);
  EXPECT_TRUE(nlohmann::json::accept(as_json.out));
  expectSays(as_json.err, "levenberg-marquardt");
}

TEST_F(Identify, RefusesAFreeListThatMakesNoSense) {
  maker.add(MeasurementKind::kPosition, 6);
  writeMeasurements("readings.csv");
  for (const char* name : {"bench.yaml", "cobra-arm.yaml"}) write(name, contentOf(shippedCells() / name));
  const std::string cell = contentOf(folder / "bench.yaml");
  write("none.yaml", cell.substr(0, cell.find("identify:")));
  expectRefused("none.yaml readings.csv", {"none.yaml: no parameter is free", "identify", "--free"});
  expectRefused("bench.yaml readings.csv --free tool.tip,tool.tip", {"--free", "freed twice", "once"});
  expectRefused("bench.yaml readings.csv --free tool.joint_stiffness.z,tool.joint_stiffness.z",
                {"--free", "freed twice"});
  expectRefused("bench.yaml readings.csv --free geometry,geometry", {"--free", "'geometry' is freed twice"});
  expectRefused("bench.yaml readings.csv --free tool.jiont_stiffness.z",
                {"--free", "tool.jiont_stiffness.z", "did you mean", "tool.joint_stiffness.z"});
  write("twice.yaml", changed(cell, "identify: [", "identify: [tool.joint_stiffness.z, "));
  expectRefused("twice.yaml readings.csv", {"twice.yaml:", "tool.joint_stiffness.z"});
  write("wrong.yaml", changed(cell, "identify: [", "identify: [tool.beem.Iz, "));
  expectRefused("wrong.yaml readings.csv", {"wrong.yaml", "identify", "tool.beem.Iz"});
}

TEST_F(Identify, RefusesMeasurementsThatTellNothing) {
  const std::string bench = shipped("bench.yaml");
  maker.add(MeasurementKind::kPosition, 6);
  const auto measurements = maker.measurements;
  maker.addTouches(1, {0}, false);
  writeMeasurements("once.csv");
  expectRefused(bench + " once.csv" + kFree, {"once.csv:8:", "point P7", "touched only once", "remove"});
  maker.measurements.assign(5, measurements[0]);
  for (std::size_t k = 0; k < 5; ++k) maker.measurements[k].id = std::to_string(k);
  writeMeasurements("same.csv");
  expectRefused(bench + " same.csv" + kFree, {"same.csv:", "one posture", "several postures"});
  maker.measurements = measurements;
  for (auto& m : maker.measurements) m.is_held_out = true;
  std::string text = measurementsCsv(measurements);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 10)
    text.insert(at, text.substr(0, at).find('\n') == std::string::npos ? ",split   " : ",held-out");
  write("held.csv", changed(text, ",split   ", ",split"));
  expectRefused(bench + " held.csv" + kFree, {"held.csv:", "there is no reading to fit", "held-out"});
  write("few.csv", measurementsCsv({measurements[0]}));
  expectRefused(shipped("bowl.yaml") + " few.csv" + kFree, {"few.csv:", "posture"});
  write("two.csv", measurementsCsv({measurements[0], measurements[1]}));
  expectRefused(shipped("bowl.yaml") + " two.csv" + kFree, {"two.csv:", "6 numbers", "8 free numbers", "add readings"});
}

TEST_F(Identify, RefusesFilesThatAreBroken) {
  const std::string bench = shipped("bench.yaml");
  maker.add(MeasurementKind::kPosition, 4);
  writeMeasurements("good.csv");
  write("empty.csv", "");
  expectRefused(bench + " empty.csv" + kFree, {"empty.csv", "empty"});
  write("header.csv", contentOf(folder / "good.csv").substr(0, contentOf(folder / "good.csv").find('\n') + 1));
  expectRefused(bench + " header.csv" + kFree, {"header.csv", "no readings below the header"});
  expectRefused(bench + " missing.csv" + kFree, {"missing.csv", "no such file"});
  write("nosigma.csv", measurementsCsv(maker.measurements, false));
  expectRefused(bench + " nosigma.csv" + kFree, {"nosigma.csv:2", "no sigma", "sigma_in", "--sigma"});
  for (const char* number : {"nan", "inf", "NaN", "1e999"}) {
    auto lines = measurementsCsv(maker.measurements);
    const std::size_t end = lines.find_last_of(',');
    write("nan.csv", lines.substr(0, end + 1) + number + "\n");
    expectRefused(bench + " nan.csv" + kFree, {"nan.csv:5 (column sigma_in)", number, "a finite number"});
  }
  expectRefused(bench + " good.csv --sigma nan" + kFree, {"--sigma", "nan"});
  expectRefused(bench + " good.csv --sigma -1" + kFree, {"--sigma", "-1"});
  EXPECT_EQ(run("identify " + bench + " nosigma.csv --sigma 0.003" + kFree).exit_code, 0);
}

TEST_F(Identify, TouchesThatContradictEachOtherAreNamed) {
  maker.addTouches(6, {0, 20 * kPound, 40 * kPound}, false);
  maker.measurements[4].q[1] += 1 * kDegree;  // an error of about an inch at the tip
  writeMeasurements("readings.csv");
  const json result = identified(shipped("bench.yaml") + " readings.csv" + kFree);
  ASSERT_FALSE(result["outliers"].empty());
  EXPECT_EQ(result["outliers"][0]["id"], "5");
  EXPECT_GT(result["outliers"][0]["size"], 0.3);
  EXPECT_GT(result["outliers"][0]["sigmas"], 10);
  expectSays(run("identify " + shipped("bench.yaml") + " readings.csv" + kFree).out, "outlier: reading 5");
}

TEST_F(Identify, OfTwoTouchesThatContradictBothAreNamed) {
  maker.addTouches(8, {0, 30 * kPound}, false);
  maker.measurements[4].q[1] += 1 * kDegree;
  writeMeasurements("readings.csv");
  const json result = identified(shipped("bench.yaml") + " readings.csv" + kFree);
  ASSERT_EQ(result["outliers"].size(), 2u) << result["outliers"];
  std::vector<std::string> ids{result["outliers"][0]["id"], result["outliers"][1]["id"]};
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, (std::vector<std::string>{"5", "6"}));
}

TEST_F(Identify, WarnsOfLoadsInTheWrongUnit) {
  maker.add(MeasurementKind::kPosition, 10);
  const auto measurements = maker.measurements;
  for (auto& m : maker.measurements) m.load *= 1000;
  writeMeasurements("heavy.csv");
  const Outcome heavy = run("identify " + shipped("bench.yaml") + " heavy.csv" + kFree + " --json -");
  EXPECT_LE(heavy.exit_code, 1) << heavy.err;
  expectWarns(json::parse(heavy.out), "the load");
  maker.measurements = measurements;
  for (auto& m : maker.measurements) m.load /= 1000;
  writeMeasurements("light.csv");
  const Outcome light = run("identify " + shipped("bench.yaml") + " light.csv" + kFree + " --json -");
  EXPECT_LE(light.exit_code, 1) << light.err;
  expectWarns(json::parse(light.out), "--assume loads=kip");
}

TEST_F(Identify, WarnsOfRadiansUnderAColumnInDegrees) {
  maker.add(MeasurementKind::kPosition, 10);
  for (auto& m : maker.measurements) m.q *= kDegree;
  writeMeasurements("radians.csv");
  for (const char* cell : {"bench.yaml", "bowl.yaml"}) {
    const Outcome outcome = run("identify " + shipped(cell) + " radians.csv" + kFree + " --json -");
    EXPECT_LE(outcome.exit_code, 1) << outcome.err;
    SCOPED_TRACE(cell);
    expectWarns(json::parse(outcome.out), "--assume angles=rad");
  }
}

TEST_F(Identify, WarnsOfCoordinatesInTheWrongUnit) {
  maker.add(MeasurementKind::kPosition, 10);
  for (auto& m : maker.measurements) *m.p_W *= 25.4;
  writeMeasurements("millimetres.csv");
  const Outcome outcome = run("identify " + shipped("bench.yaml") + " millimetres.csv" + kFree + " --json -");
  EXPECT_LE(outcome.exit_code, 1) << outcome.err;
  expectWarns(json::parse(outcome.out), "--assume coordinates=mm");
}

TEST_F(Identify, EverySetUpGetsACellOfItsOwnWithItsBase) {
  PlacedArm truth{deflection::cobraArm(),
                  {{"in", calibration::poseOf({0.05, -0.03, 0.02}, {0.01, -0.02, 0.05}), false},
                   {"over there/2", calibration::poseOf({-0.04, 0.06, 0.01}, {-0.02, 0.01, -0.08}), false}}};
  MeasurementMaker two(truth, 7, MeasurementMaker::Noise::kStated);
  for (const char* setup : {"in", "over there/2"}) two.add(MeasurementKind::kPosition, 25, setup);
  write("two.csv", measurementsCsv(two.measurements));
  (void)identified(shipped("bowl.yaml") + " two.csv --out found.yaml" + kFree);
  const Cell first = readCell((folder / "found-setup-in.yaml").string());
  const Cell second = readCell((folder / "found-setup-2-of-2.yaml").string());
  EXPECT_LT((first.X_WB.translation() - truth.base_poses[0].X_WB.translation()).norm(), 1e-3);
  EXPECT_LT((second.X_WB.translation() - truth.base_poses[1].X_WB.translation()).norm(), 1e-3);
  ASSERT_TRUE(first.base_covariance && second.base_covariance);
  EXPECT_GT(first.base_covariance->trace(), 0);
  EXPECT_EQ(first.arm_path, second.arm_path);
  EXPECT_EQ(readCell((folder / "found.yaml").string()).X_WB.translation(), Eigen::Vector3d::Zero());
}

TEST_F(Identify, TouchesOfUnknownPointsInRadiansUnderADegreesHeaderAreFlagged) {
  maker.addTouches(10, {0, 30 * kPound}, false);
  auto measurements = maker.measurements;
  for (auto& measurement : measurements) measurement.q *= kDegree;  // radians under a heading in degrees
  write("radians.csv", measurementsCsv(measurements));
  const Outcome outcome = run("identify " + shipped("bench.yaml") + " radians.csv --json -" + kFree);
  expectWarns(json::parse(outcome.out), "are they radians?");
  writeMeasurements("degrees.csv");
  const json degrees = identified(shipped("bench.yaml") + " degrees.csv" + kFree);
  for (const auto& warning : degrees["warnings"])
    EXPECT_EQ(warning.get<std::string>().find("radians"), std::string::npos) << warning;
}

TEST_F(Identify, TouchesOfUnknownPointsThatFitBetterThanTheirNoiseAreFlagged) {
  const std::vector<double> loads{0, 20 * kPound, 40 * kPound};
  MeasurementMaker exact(trueArm(), 5, MeasurementMaker::Noise::kNone);
  exact.addTouches(30, loads, false);
  write("exact.csv", measurementsCsv(exact.measurements));
  expectWarns(identified(shipped("bench.yaml") + " exact.csv" + kFree), "an arm that shrinks");
  maker.addTouches(30, loads, false);
  writeMeasurements("noisy.csv");
  const json noisy = identified(shipped("bench.yaml") + " noisy.csv" + kFree);
  for (const auto& warning : noisy["warnings"])
    EXPECT_EQ(warning.get<std::string>().find("shrinks"), std::string::npos) << warning;
}

}  // namespace
}  // namespace tubeplan::app
