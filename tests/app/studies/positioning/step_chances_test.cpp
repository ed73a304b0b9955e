// Tests of the step probabilities: as stated in a plan, and compared with how often steps enter with true arms of other
// physics.
#include <nlohmann/json.hpp>

#include "studies/step_chance_trials.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

TEST(StepChances, HappenAsOftenAsPredictedByArmsOfOtherPhysics) {
  Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  cell.uncertainty = testing::uncertaintyOfTrials();
  const testing::StepChanceTrials trials(cell, 3, 8);
  std::vector<testing::StepChanceTrial> found;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) found.push_back(trials.run(seed));
  const auto sum = testing::summaryOf(found);
  EXPECT_GT(sum.calibrated, 50);
  for (std::size_t steps = 0; steps < testing::kBins; ++steps) {
    EXPECT_LE(sum.standard_error[steps], 0.04) << "too few to judge by";
    EXPECT_NEAR(sum.predicted[steps], sum.happened[steps], 3 * sum.standard_error[steps]) << steps;
  }
}

class StepChancesOfAPlan : public ProgramTest {
 protected:
  StepChancesOfAPlan() {
    for (const char* name : {"mockup.yaml", "mockup-true.yaml", "cobra-arm.yaml", "cobra-arm-true.yaml"})
      write(name, contentOf(shippedCells() / name));
  }

  [[nodiscard]] json planned(const std::string& question) const {
    const Outcome outcome = run("plan " + question + " --tubes spread:5 --out plan");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(contentOf(folder / "plan/plan.json"), nullptr, false);
  }
};

TEST_F(StepChancesOfAPlan, AreNotGivenForABaseThatNobodyPlaced) {
  const json plan = planned("mockup.yaml");
  EXPECT_TRUE(plan["tubes"][0]["probability_by_steps"].is_null());
  EXPECT_TRUE(plan["probabilities"].contains("reason"));
  EXPECT_NE(plan["steps_by"].get<std::string>().find("model alone"), std::string::npos);
}

TEST_F(StepChancesOfAPlan, SayWhetherTouchesOrTheCellToldTheModelsError) {
  // Stiffness errors within the uncertainty of the arm's file do not count as an error of the model.
  const json by_touches = planned("mockup.yaml --touches auto --truth mockup-true.yaml");
  EXPECT_TRUE(by_touches["probabilities"]["model_error"].is_null());
  EXPECT_EQ(by_touches["probabilities"]["counted"],
            (std::vector<std::string>{"the encoders", "the base pose", "the arm's numbers"}));
  write("exact.yaml", contentOf(folder / "mockup.yaml") + "uncertainty: none\n");
  const json exact = planned("exact.yaml --touches auto --truth mockup-true.yaml");
  EXPECT_EQ(exact["probabilities"]["model_error"]["source"], "touches");
  write("stated.yaml", contentOf(folder / "mockup.yaml") + "model_error: 0.02\n");
  const json by_cell = planned("stated.yaml --touches auto --truth mockup-true.yaml");
  EXPECT_EQ(by_cell["probabilities"]["model_error"]["source"], "cell");
  EXPECT_NEAR(by_cell["probabilities"]["model_error"]["value"].get<double>(), 0.02, 1e-9);
  // With a model error of 0.02 in per coordinate, at most 1 - exp(-1/8) of the holes are hit within the 0.010 in that
  // the third step requires.
  for (const auto& tube : by_cell["tubes"]) EXPECT_LE(tube["probability_by_steps"][3], 0.118);
}

TEST_F(StepChancesOfAPlan, ModelErrorsThatAreNoneAreRefused) {
  for (const char* error : {"-1", "abc", "{sigma: 0.1, degrees_of_freedom: 0}", "{sig: 0.1}"}) {
    write("wrong.yaml", contentOf(folder / "mockup.yaml") + "model_error: " + error + "\n");
    const Outcome outcome = run("map wrong.yaml");
    EXPECT_EQ(outcome.exit_code, 2) << error;
    EXPECT_NE(outcome.err.find("model_error"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run("plan mockup.yaml --tubes R10C20 --standoff=-1 --out plan").exit_code, 2);
}

TEST_F(StepChancesOfAPlan, AKnownBaseWithoutAWordOnTheModelSaysSo) {
  const json plan = planned("mockup-true.yaml");
  EXPECT_TRUE(plan["probabilities"]["model_error"].is_null());
  EXPECT_EQ(plan["probabilities"]["left_out"].size(), 3u);
}

TEST_F(StepChancesOfAPlan, ACalibratedCellCarriesTheModelsErrorOn) {
  write("exact.yaml", contentOf(folder / "mockup.yaml") + "uncertainty: none\n");
  (void)planned("exact.yaml --touches auto --truth mockup-true.yaml");
  const Outcome outcome = run("calibrate exact.yaml plan/touches.csv --out placed.yaml --json -");
  const json found = json::parse(outcome.out, nullptr, false);
  EXPECT_EQ(found["model_error"]["from"], "touches");
  EXPECT_EQ(found["model_error"]["degrees_of_freedom"], 3);
  EXPECT_EQ(planned("placed.yaml")["probabilities"]["model_error"]["source"], "touches");
}

TEST_F(StepChancesOfAPlan, IdentifyWritesTheModelsErrorIntoTheCell) {
  ASSERT_EQ(run("simulate mockup-true.yaml --design bowl --readings 24 --seed 5 --out set").exit_code, 0);
  ASSERT_EQ(run("identify mockup.yaml set/measurements.csv --folds 0 --free tool.joint_stiffness.z --out found.yaml")
                .exit_code,
            0);
  const Cell cell = readCell((folder / "found.yaml").string());
  ASSERT_TRUE(cell.model_error.has_value());
  EXPECT_EQ(cell.model_error->from, "identify");
  EXPECT_GT(cell.model_error->sigma, 0);
}

}  // namespace
}  // namespace tubeplan::app
