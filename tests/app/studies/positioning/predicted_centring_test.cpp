// Tests of the predicted centring error that `tubeplan identify` reports.
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class PredictedCentring : public ProgramTest {
 protected:
  PredictedCentring() {
    for (const char* name : {"mockup.yaml", "mockup-true.yaml", "cobra-arm.yaml", "cobra-arm-true.yaml"})
      write(name, contentOf(shippedCells() / name));
  }

  void measure(int measurements, int seed) const {
    const Outcome outcome = run("simulate mockup-true.yaml --design bowl --readings " + std::to_string(measurements) +
                                " --seed " + std::to_string(seed) + " --out set");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  [[nodiscard]] json identified(const std::string& more = "") const {
    const Outcome outcome =
        run("identify mockup.yaml set/measurements.csv --folds 0 --json - --free "
            "tool.joint_stiffness.z,latch-link.beam.Iz,mezzanine-beam.beam.Iz,"
            "mezzanine-platform.joint_stiffness.x" +
            more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false)["predicted_centring_error"];
  }
};

TEST_F(PredictedCentring, isOrderedHasItsBandAndSaysWhatItCounts) {
  measure(24, 5);
  const json found = identified();
  EXPECT_EQ(found["unit"], "in");
  EXPECT_EQ(found["uncertain_numbers"], 10) << "four stiffnesses and the base";
  EXPECT_EQ(found["holes"].get<int>() + found["holes_out_of_reach"].get<int>(), 200);
  EXPECT_EQ(found["holes_on_sheet"], 4674);
  EXPECT_EQ(found["sampled"], true);
  EXPECT_LT(found["median"], found["p95"]);
  EXPECT_LT(found["p95"], found["worst"]["value"]);
  EXPECT_TRUE(found["worst"]["hole"].get<std::string>().starts_with("R"));
  for (const char* name : {"median", "p95", "worst"}) {
    const json& value = found[name].is_object() ? found[name]["value"] : found[name];
    EXPECT_LT(found["band"][name][0], value) << name;
    EXPECT_GT(found["band"][name][1], value) << name;
  }
  EXPECT_GT(found["encoder_noise"]["median"], 0);
  EXPECT_LE(found["encoder_noise"]["median"], found["encoder_noise"]["worst"]);
  EXPECT_EQ(identified(), found);
}

TEST_F(PredictedCentring, fallsWithTheRootOfTheMeasurements) {
  measure(24, 5);
  const double few = identified()["median"];
  measure(216, 5);
  const double many = identified()["median"];
  EXPECT_NEAR(few / many, 3, 0.9);
}

// The predicted error agrees with the error of the simulated true arm at the holes. One fit in 20 lies outside its
// predicted band, so the mean over three fits is tested.
TEST_F(PredictedCentring, isWhatTheTrueArmDoes) {
  double predicted = 0, real = 0;
  for (const int seed : {11, 12, 13}) {
    measure(36, seed);
    predicted += identified(" --out found.yaml")["median"].get<double>() / 3;
    write("found.yaml", changed(contentOf(folder / "found.yaml"), "known: false", "known: true"));
    const Outcome outcome = run("ladder set/measurements.csv found.yaml --truth mockup-true.yaml --holes 200 --json -");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    real += json::parse(outcome.out)["models"][0]["steps"]["centring_error"]["median"].get<double>() / 3;
  }
  EXPECT_GT(real, predicted / 2.5);
  EXPECT_LT(real, 2.5 * predicted);
}

TEST_F(PredictedCentring, aCellWithoutASheetHasNone) {
  const Outcome made = run("simulate " + shipped("bench.yaml") + " --design bench --readings 30 --seed 1 --out bench");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string call = "identify " + shipped("bench.yaml") + " bench/measurements.csv --folds 0";
  const json found = json::parse(run(call + " --json -").out)["predicted_centring_error"];
  expectSays(found["reason"], "no tube sheet");
  EXPECT_FALSE(found.contains("median"));
  EXPECT_EQ(run(call).out.find("predicted centring"), std::string::npos);
}

TEST_F(PredictedCentring, isPrinted) {
  measure(24, 5);
  const Outcome outcome = run("identify mockup.yaml set/measurements.csv --folds 0 --free tool.joint_stiffness.z");
  expectSays(outcome.out, "predicted centring error over ");
  expectSays(outcome.out, "of 4674 holes");
  expectSays(outcome.out, "encoder noise");
}

}  // namespace
}  // namespace tubeplan::app
