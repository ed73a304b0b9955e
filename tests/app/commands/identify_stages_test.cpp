// In `tubeplan identify`, a stage passes its parameters and their uncertainty on to the next, and --drop removes
// parameters that are not significant; the output reports both.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "tests/app/formats/measurements/measurements_csv.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using calibration::Measurement, calibration::MeasurementKind, calibration::PlacedArm, calibration::MeasurementMaker;
using nlohmann::json;

constexpr const char* kFirst = "tool.joint_stiffness.z";
constexpr const char* kSecond = "latch-link.beam.Iz";

class IdentifyStages : public ProgramTest {
 protected:
  IdentifyStages() {
    PlacedArm truth{deflection::cobraArm(), {{"A", Eigen::Isometry3d::Identity(), true}}};
    truth.base_poses.push_back({"B", Eigen::Isometry3d::Identity(), true});
    truth.arm.rows[5].joint_stiffness.z() *= 0.8;
    MeasurementMaker maker(truth, 77, MeasurementMaker::Noise::kStated);
    maker.add(MeasurementKind::kPosition, 6, "A");
    for (Measurement& measurement : maker.measurements) measurement.id = "A" + measurement.id;
    of_a = maker.measurements;
    maker.add(MeasurementKind::kPosition, 12, "B");
    all = maker.measurements;
    of_b.assign(all.begin() + 6, all.end());
    write("all.csv", measurementsCsv(all));
    write("a.csv", measurementsCsv(of_a));
    write("b.csv", measurementsCsv(of_b));
    for (const char* name : {"bench.yaml", "cobra-arm.yaml"}) write(name, contentOf(shippedCells() / name));
  }

  [[nodiscard]] json identified(const std::string& arguments) const {
    const Outcome outcome = run("identify " + arguments + " --folds 0 --json -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Returns the parameter kSecond, identified from the second set-up with kFirst fixed at `stiffness` [lbf*in/deg].
  [[nodiscard]] json secondWithFirstAt(double stiffness) const {
    write("cobra-arm.yaml",
          changed(contentOf(shippedCells() / "cobra-arm.yaml"), "z: 5588", fmt::format("z: {:.12g}", stiffness)));
    return identified(fmt::format("bench.yaml b.csv --free {}", kSecond))["parameters"][0];
  }

  std::vector<Measurement> of_a, of_b, all;
};

// Rows that the cell states as rigid in one set-up, on a bench, stay flexible in the other, on the mezzanine. Without
// that statement, the measurements of both set-ups do not fit.
TEST_F(IdentifyStages, AMountingThatIsRigidInOneSetUpLeavesTheOthersTheirs) {
  PlacedArm truth{deflection::cobraArm(), {{"bench", Eigen::Isometry3d::Identity(), true}}};
  truth.arm.rows[5].joint_stiffness.z() *= 0.8;
  truth.arm.rows[1].joint_stiffness.x() *= 1.2;
  truth.arm.mountings = {{"bench", {0, 1}}};
  truth.base_poses.push_back({"mezzanine", Eigen::Isometry3d::Identity(), true});
  MeasurementMaker maker(truth, 78, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 15, "bench");
  maker.add(MeasurementKind::kPosition, 15, "mezzanine");
  write("both.csv", measurementsCsv(maker.measurements));
  const std::string cell = contentOf(shippedCells() / "bench.yaml");
  write("stages.yaml", cell + "\nsetups: {bench: {rigid: [mezzanine-beam, mezzanine-platform]}}\n");
  const json found =
      identified("stages.yaml both.csv --free tool.joint_stiffness.z,mezzanine-platform.joint_stiffness.x");
  EXPECT_GT(found["p_value"], 1e-3);
  EXPECT_NEAR(found["parameters"][0]["value"], 0.8 * 5588, 5 * found["parameters"][0]["sigma"].get<double>());
  EXPECT_NEAR(found["parameters"][1]["value"], 1.2 * 6543, 5 * found["parameters"][1]["sigma"].get<double>());
  const json without = identified(
      "bench.yaml both.csv --assume as-is --free tool.joint_stiffness.z,mezzanine-platform.joint_stiffness.x");
  EXPECT_LT(without["p_value"].get<double>(), 1e-6);
  write("typo.yaml", cell + "\nsetups: {bnech: {rigid: [mezzanine-beam]}}\n");
  const Outcome typo = run("identify typo.yaml both.csv --free tool.joint_stiffness.z");
  EXPECT_EQ(typo.exit_code, 1) << typo.err;  // half of the measurements contradict the cell
  expectSays(typo.out, "no reading is of the set-up 'bnech'");
  expectSays(typo.out, "did you mean 'bench'?");
}

// The variance in the second stage is the sum of its own and that passed on from the first stage, because the set-ups
// have independent noise. The derivative d second / d first is found by moving the first parameter by a tenth of its
// sigma.
TEST_F(IdentifyStages, theSecondStageCarriesWhatTheFirstLeftOpen) {
  const json staged = identified(fmt::format("bench.yaml all.csv --stage {}:A --stage {}:B", kFirst, kSecond));
  ASSERT_EQ(staged["parameters"].size(), 1u);
  const json& second = staged["parameters"][0];
  EXPECT_EQ(second["name"], kSecond);

  const json first = identified(fmt::format("bench.yaml a.csv --free {}", kFirst))["parameters"][0];
  const double value = first["value"], sigma = first["sigma"];
  EXPECT_LT(value, 5588);
  const json exact = secondWithFirstAt(value);
  EXPECT_NEAR(second["value"], exact["value"], 0.02 * exact["sigma"].get<double>());
  const double exact_sigma = exact["sigma"], staged_sigma = second["sigma"];
  EXPECT_GT(staged_sigma, 1.1 * exact_sigma) << "the first stage left something open";

  const double shift =
      (secondWithFirstAt(value + sigma / 10)["value"].get<double>() - exact["value"].get<double>()) * 10;
  EXPECT_NEAR(staged_sigma, std::hypot(exact_sigma, shift), 0.03 * staged_sigma);
  const double lower = second["interval"][0], upper = second["interval"][1];
  EXPECT_GT(upper - lower, 3.5 * staged_sigma);
}

TEST_F(IdentifyStages, everyStageIsPrintedAndTheWholeIsWritten) {
  const Outcome outcome = run(
      fmt::format("identify bench.yaml all.csv --folds 0 --stage {}:A --stage {}:B --out found.yaml", kFirst, kSecond));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expectSays(outcome.out, "stage 1");
  expectSays(outcome.out, kFirst);
  expectSays(outcome.out, kSecond);
  expectSays(outcome.out, "errors of 6 readings");
  expectSays(outcome.out, "errors of 12 readings");
  const json compared = json::parse(run("compare found.yaml b.csv --folds 0 --json -").out);
  const json staged = identified(fmt::format("bench.yaml all.csv --stage {}:A --stage {}:B", kFirst, kSecond));
  EXPECT_NEAR(compared["rms"]["before"], staged["rms"]["after"], 1e-6);
}

// An outlier of the second stage is reported with its own id: it is the third measurement of that stage and the ninth
// of the file.
TEST_F(IdentifyStages, anOutlierOfALaterStageHasItsOwnName) {
  all[8].p_W->x() += 0.1 * kInch;
  write("all.csv", measurementsCsv(all));
  const json staged = identified(fmt::format("bench.yaml all.csv --stage {}:A --stage {}:B", kFirst, kSecond));
  ASSERT_EQ(staged["outliers"].size(), 1u) << staged["outliers"];
  EXPECT_EQ(staged["outliers"][0]["id"], all[8].id);
}

TEST_F(IdentifyStages, aStageWithoutMeasurementsOrWithAStrangeNameIsRefused) {
  const Outcome nowhere = run(fmt::format("identify bench.yaml all.csv --stage {}:C", kFirst));
  EXPECT_EQ(nowhere.exit_code, 2) << nowhere.out;
  const Outcome strange = run("identify bench.yaml all.csv --stage tool.jiont_stiffness.z");
  EXPECT_EQ(strange.exit_code, 2);
  expectSays(strange.err, "did you mean");
  const Outcome both = run(fmt::format("identify bench.yaml all.csv --free tool.tip --stage {}", kFirst));
  EXPECT_EQ(both.exit_code, 2);
  expectSays(both.err, "--free");
}

// --drop removes a parameter that the measurements do not need: the elbow's joint offset, whose true value is that of
// the drawing.
TEST_F(IdentifyStages, dropGivesUpWhatTheMeasurementsDoNotNeedAndSaysWhy) {
  const std::string free = fmt::format(" --free {},forearm.joint.offset", kFirst);
  const json kept = identified("bench.yaml all.csv" + free);
  EXPECT_EQ(kept["parameters"].size(), 2u);
  EXPECT_TRUE(kept["dropped"].empty());
  const json dropped = identified("bench.yaml all.csv --drop 0.05" + free);
  ASSERT_EQ(dropped["parameters"].size(), 1u);
  EXPECT_EQ(dropped["parameters"][0]["name"], kFirst);
  ASSERT_EQ(dropped["dropped"].size(), 1u);
  const std::string why = dropped["dropped"][0];
  expectSays(why, "forearm.joint.offset: not significant (p = 0.");
  expectSays(why, "kept at its initial value");
  EXPECT_LT(dropped["parameters"][0]["sigma"], kept["parameters"][0]["sigma"]);
  const double p = std::stod(why.substr(why.find("p = ") + 4));
  const json& offset = kept["parameters"][1];
  const double sigmas =
      std::abs(offset["value"].get<double>() - offset["start"].get<double>()) / offset["sigma"].get<double>();
  EXPECT_NEAR(p, std::erfc(sigmas / std::sqrt(2.)), 0.002);
  expectSays(run("identify bench.yaml all.csv --folds 0 --drop 0.05" + free).out, "  dropped forearm.joint.offset: ");
}

// --drop keeps a parameter whose true value is far from the drawing.
TEST_F(IdentifyStages, dropKeepsWhatIsNeeded) {
  const json found = identified(fmt::format("bench.yaml all.csv --drop 0.001 --free {}", kFirst));
  ASSERT_EQ(found["parameters"].size(), 1u);
  EXPECT_TRUE(found["dropped"].empty());
}

// If the true tool joint is rigid, its stiffness is dropped, the written cell has a rigid joint, and its errors are
// those of the fit.
TEST_F(IdentifyStages, aDroppedStiffnessIsRigidInTheWrittenCell) {
  PlacedArm truth{deflection::cobraArm(), {{"", Eigen::Isometry3d::Identity(), true}}};
  truth.arm.rows[5].joint_stiffness.z() = deflection::kRigid;
  MeasurementMaker maker(truth, 78, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 30);
  write("rigid.csv", measurementsCsv(maker.measurements));
  const json found =
      identified(fmt::format("bench.yaml rigid.csv --drop 0.01 --out found.yaml --free {},{}", kFirst, kSecond));
  ASSERT_EQ(found["dropped"].size(), 1u) << found["parameters"];
  expectSays(found["dropped"][0], "tool.joint_stiffness.z: not significant");
  expectSays(found["dropped"][0], "taken as rigid");
  const Cell written = readCell((folder / "found.yaml").string());
  EXPECT_TRUE(std::isinf(written.arm.rows[5].joint_stiffness.z())) << written.arm.rows[5].joint_stiffness.z();
  EXPECT_FALSE(std::isinf(written.arm.rows[4].joint_stiffness.z()));
  const json compared = json::parse(run("compare found.yaml rigid.csv --folds 0 --json -").out);
  EXPECT_NEAR(compared["rms"]["before"], found["rms"]["after"], 1e-6);
}

}  // namespace
}  // namespace tubeplan::app
