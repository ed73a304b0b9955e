// Commands with valid requests write the expected results, and `verify` refutes plans that were altered.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class Commands : public ProgramTest {
 protected:
  [[nodiscard]] json jsonOf(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Plans visits to a few tubes, with simulated touches, and writes the plan to the folder `name`.
  [[nodiscard]] Outcome plan(const std::string& name, const std::string& more = "--tubes spread:6") const {
    return run("plan " + shipped("mockup.yaml") + " --touches auto --truth " + shipped("mockup-true.yaml") +
               " --seed 3 --out " + name + " " + more);
  }

  [[nodiscard]] json planJson(const std::string& name) const {
    return json::parse(contentOf(folder / name / "plan.json"));
  }
  void writePlanJson(const std::string& name, const json& plan) const { (void)write(name + "/plan.json", plan.dump()); }
};

TEST_F(Commands, poseGivesRigidFlexibleAndChange) {
  const json pose =
      jsonOf("pose " + shipped("bench.yaml") + " --joints=-36.688,46.138,-35.856,-11.127 --load 30 --all");
  EXPECT_NEAR(pose["rigid"]["position"][0], 68.688, 0.0015);
  EXPECT_NEAR(pose["change"]["position"][2], -2.315, 0.0015);
  EXPECT_NEAR(pose["flexible"]["fixed_angles"][1].get<double>() - pose["rigid"]["fixed_angles"][1].get<double>(), 2.275,
              0.0015);
  EXPECT_EQ(pose["units"]["length"], "in");
  EXPECT_GT(pose["iterations"], 2);
  EXPECT_EQ(pose["intermediates"]["rows"].size(), 6u);
  EXPECT_EQ(pose["intermediates"]["components"].size(), 6u);
  // The weight of the arm and the load of 30 lbf act on the first row.
  EXPECT_NEAR(
      pose["intermediates"]["rows"][0]["force_base"][2],
      -(26.7 + 20 + 10.4 + 0.152 * 13.202 + 0.403 * 26.406 + 0.126 * 19.4 + 1.2062 * std::hypot(16.2493, 7.8471) + 30),
      1e-6);
}

TEST_F(Commands, calibrateFindsTheBaseThatAPlanTouchedWith) {
  ASSERT_EQ(plan("made").exit_code, 0);
  const Outcome outcome = run("calibrate " + shipped("mockup.yaml") + " made/touches.csv --out again.yaml --json -");
  EXPECT_EQ(outcome.exit_code, 0) << "the true arm's stiffnesses are off by what its file leaves open";
  const json found = json::parse(outcome.out, nullptr, false);
  const json made = planJson("made");
  EXPECT_EQ(found["status"], "done");
  EXPECT_EQ(found["residuals"].size(), 3u);
  EXPECT_EQ(found["distances"].size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found["base"]["position"][k], made["base"]["position"][k], 1e-6);
  const json map = jsonOf("map again.yaml");
  EXPECT_EQ(map["holes"], 4674);
  expectSays(contentOf(folder / "again.yaml"), "known: true");
}

TEST_F(Commands, planKeepsItsPromisesAndVerifyProvesIt) {
  const Outcome outcome = plan("made");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_LE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 24) << "more than one screen";
  const json made = planJson("made");
  EXPECT_EQ(made["tubes"].size() + made["unreachable"].size(), 6u);
  EXPECT_GE(made["tubes"].size(), 4u);
  EXPECT_EQ(made["seed"], 3);
  EXPECT_GE(made["min_clearance"], 0.25);
  EXPECT_GE(made["travel_time_s"], made["lower_bound_s"]);
  for (const auto& tube : made["tubes"]) {
    EXPECT_LE(tube["centring_error"], 1e-6);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(tube["predicted_tip"][k], tube["hole"][k], 1e-6);
    double sum = 0;
    for (const auto& p : tube["probability_by_steps"]) sum += p.get<double>();
    EXPECT_NEAR(sum, 1, 1e-9);
    // The score without compensation is null for a hole that the rigid model does not reach.
    const json& none = tube["scored"]["none"];
    if (!none.is_null()) {
      EXPECT_LT(tube["scored"]["via_point"]["error"], none["error"]);
    }
  }
  const Outcome proof = run("verify " + shipped("mockup.yaml") + " made");
  EXPECT_EQ(proof.exit_code, 0) << proof.out << proof.err;
  expectSays(proof.out, "proved");
}

TEST_F(Commands, bodiesThatNoPosturePartsAreNamedByThePlanItsReportAndVerify) {
  const Outcome planned = run("plan " + shipped("puma.yaml") + " --tubes spread:12 --out made");
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const json warnings = planJson("made")["warnings"];
  ASSERT_EQ(warnings.size(), 2u) << "the other is of the base, which nobody placed";
  const std::string warning =
      warnings[0].get<std::string>().find("not checked") != std::string::npos ? warnings[0] : warnings[1];
  expectSays(warning, "not checked against each other");
  expectSays(planned.out, warning);
  expectSays(contentOf(folder / "made/report.html"), warning);
  expectSays(run("verify " + shipped("puma.yaml") + " made").out, warning);
}

TEST_F(Commands, theSameSeedGivesTheSameBytes) {
  ASSERT_EQ(plan("one").exit_code, 0);
  ASSERT_EQ(plan("two").exit_code, 0);
  for (const char* file : {"plan.json", "path.csv", "report.html", "touches.csv", "cell.yaml"})
    EXPECT_EQ(contentOf(folder / "one" / file), contentOf(folder / "two" / file)) << file;
}

TEST_F(Commands, verifyRefutesAPlanThatWasChanged) {
  ASSERT_EQ(plan("made").exit_code, 0);
  const json made = planJson("made");
  json altered = made;
  altered["tubes"][1]["joints"][2] = altered["tubes"][1]["joints"][2].get<double>() + 0.001;
  writePlanJson("made", altered);
  const Outcome joint = run("verify " + shipped("mockup.yaml") + " made");
  EXPECT_EQ(joint.exit_code, 1);
  expectSays(joint.out, "REFUTED");
  altered = made;
  altered["tubes"].erase(1);
  writePlanJson("made", altered);
  EXPECT_EQ(run("verify " + shipped("mockup.yaml") + " made").exit_code, 1);
  writePlanJson("made", made);
  for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  (void)write("mockup.yaml", changed(contentOf(folder / "mockup.yaml"), "radius: 6}}", "radius: 29}}"));
  const Outcome moved = run("verify mockup.yaml made");
  EXPECT_EQ(moved.exit_code, 1);
  expectSays(moved.out, "nozzle-dam");
}

TEST_F(Commands, verifyRefutesAnotherSheetOrArm) {
  ASSERT_EQ(plan("made", "--tubes R20C40,R22C44").exit_code, 0);
  for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  (void)write("cold.yaml", changed(changed(changed(contentOf(folder / "mockup.yaml"), "leg: hot", "leg: cold"),
                                           "normal: [0, 1, 0]", "normal: [0, -1, 0]"),
                                   "[-33.1, 33.1,", "[-33.1, -33.1,"));
  const Outcome sheet = run("verify cold.yaml made");
  EXPECT_EQ(sheet.exit_code, 1);
  expectSays(sheet.out, "another sheet");
  (void)write("cobra-arm.yaml", changed(contentOf(folder / "cobra-arm.yaml"), "{z: 5588}", "{z: 5589}"));
  const Outcome arm = run("verify mockup.yaml made");
  EXPECT_EQ(arm.exit_code, 1);
  expectSays(arm.out, "tool.joint_stiffness.z");
}

TEST_F(Commands, verifyRefutesAToolThatLeansMoreThanItsFirstStepAllows) {
  ASSERT_EQ(plan("made", "--tubes R20C40,R22C44").exit_code, 0);
  for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  // The first step is so long that any tilt of the tool is too large.
  (void)write("long.yaml", changed(contentOf(folder / "mockup.yaml"), "lengths: [0.5,", "lengths: [9000,"));
  const Outcome outcome = run("verify long.yaml made");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  expectSays(outcome.out, "the tool leans by");
  // A plan is also refuted if the tilt that it states differs from that of the model.
  json made = planJson("made");
  made["tubes"][0]["tilt"] = 0.17;
  writePlanJson("made", made);
  expectSays(run("verify " + shipped("mockup.yaml") + " made").out, "the stated tilt is not the model's");
}

TEST_F(Commands, aPlanWithoutCompensationIsProvedToDoWhatItStates) {
  ASSERT_EQ(plan("made", "--compensation none --tubes spread:6").exit_code, 0);
  double largest = 0;
  const json made = planJson("made");
  for (const auto& tube : made["tubes"]) largest = std::max(largest, tube["centring_error"].get<double>());
  EXPECT_GT(largest, 0.05);
  const Outcome proof = run("verify " + shipped("mockup.yaml") + " made");
  EXPECT_EQ(proof.exit_code, 0) << proof.out;
}

TEST_F(Commands, verifyNamesTubesThatTheMapHasPluggedSince) {
  ASSERT_EQ(plan("made", "--tubes R20C40,R22C44").exit_code, 0);
  ASSERT_EQ(run("map " + shipped("mockup.yaml") + " --csv holes.csv").exit_code, 0);
  const std::string map = contentOf(folder / "holes.csv");
  const auto line = map.find("\n20,40,") + 1, end = map.find('\n', line);
  writeMappedMockup("plugged.yaml",
                    map.substr(0, line) + changed(map.substr(line, end - line), "open", "plugged") + map.substr(end));
  const Outcome outcome = run("verify plugged.yaml made");
  expectSays(outcome.out + outcome.err, "1 of the 2 planned tubes would be left out unless named: R20C40 (plugged)");
}

TEST_F(Commands, mapWarnsOfExchangedNames) {
  ASSERT_EQ(run("map " + shipped("mockup.yaml") + " --csv holes.csv").exit_code, 0);
  const std::string map = contentOf(folder / "holes.csv");
  writeMappedMockup("exchanged.yaml", changed(changed(changed(map, "\n20,40,", "\n20,0,"), "\n20,41,", "\n20,40,"),
                                              "\n20,0,", "\n20,41,"));
  const json found = jsonOf("map exchanged.yaml");
  ASSERT_EQ(found["warnings"].size(), 2u) << found["warnings"];
  expectSays(run("map exchanged.yaml").out,
             "R20C41 is not at the position that its row gives for column 41, R20C40 is");
  EXPECT_EQ(jsonOf("map " + shipped("mockup.yaml"))["warnings"], json::array());
}

TEST_F(Commands, planWritesOverNoFilesButThoseOfAPlan) {
  std::filesystem::create_directories(folder / "mine");
  (void)write("mine/cell.yaml", "not a plan's");
  const Outcome outcome = plan("mine", "--tubes R20C40");
  EXPECT_EQ(outcome.exit_code, 2);
  expectSays(outcome.err, "cell.yaml was not written by an earlier run of this command");
  EXPECT_EQ(contentOf(folder / "mine/cell.yaml"), "not a plan's");
}

TEST_F(Commands, planSaysWhatIsInTheWay) {
  for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
  (void)write("blocked.yaml", changed(contentOf(folder / "mockup.yaml"), "scene:\n",
                                      "scene:\n  - {name: wall, box: {center: [0, 20, -20], size: [120, 1, 30]}}\n"));
  const Outcome outcome = run("plan blocked.yaml --tubes R2C57 --out made");
  EXPECT_EQ(outcome.exit_code, 1);
  expectSays(outcome.err, "wall");
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
}

TEST_F(Commands, scoreCountsStepsOfEachMode) {
  const json score = jsonOf("score " + shipped("mockup.yaml") + " --truth " + shipped("mockup-true.yaml") +
                            " --tubes spread:8 --seed 2");
  int scored = 0;
  for (const auto& tube : score["tubes"]) {
    if (tube.contains("unreachable")) continue;
    ++scored;
    EXPECT_NEAR(tube["goal_point"]["centring_error"], tube["via_point"]["centring_error"], 1e-6);
  }
  for (const char* mode : {"none", "goal_point", "via_point"}) {
    int sum = 0;
    for (const auto& count : score["counts"][mode]) sum += count.get<int>();
    EXPECT_LE(sum, scored) << mode;
  }
  EXPECT_GT(score["counts"]["none"][0], score["counts"]["via_point"][0]);
}

TEST_F(Commands, scoreRepeatsTheThesisExperiment) {
  const json runs =
      jsonOf("score " + shipped("mockup.yaml") + " --truth " + shipped("mockup.yaml") + " --runs 6 --seed 5");
  EXPECT_EQ(runs["runs"].get<std::size_t>() + runs["refused"].size(), 6u);
  EXPECT_NEAR(runs["mean_touch_error"], 0.030, 0.004);
  // Table 5.7 of Calkins 1994: in how many of ten holes 0, 1, 2 or 3 steps entered, without and with compensation.
  const std::vector<double> without{7, 2, 1, 0}, with{0, 4, 4, 2};
  EXPECT_EQ(runs["none"]["mean_counts"].size(), without.size());
  EXPECT_NEAR(runs["none"]["mean_counts"][0], without[0], 3);
  EXPECT_NEAR(runs["via_point"]["mean_counts"][0], with[0], 2);
  EXPECT_FALSE(runs.contains("thesis_table_5_7")) << "no figure of another arm";
}

TEST_F(Commands, scoreRepeatsTheExperimentOnTheTubesThatAreNamed) {
  const std::string question =
      "score " + shipped("mockup.yaml") + " --truth " + shipped("mockup.yaml") + " --runs 2 --seed 5 --tubes ";
  EXPECT_NE(jsonOf(question + "spread:20")["none"], jsonOf(question + "spread:80")["none"]);
  const Outcome few = run(question + "spread:9");
  EXPECT_EQ(few.exit_code, 1);
  expectSays(few.err, "of the 9 holes can be reached, and 14 are needed");
}

TEST_F(Commands, scoreRefusesOptionsOfRunsWithoutRuns) {
  const std::string question = "score " + shipped("mockup.yaml") + " --truth " + shipped("mockup.yaml");
  expectSays(run(question + " --unmodelled 0.1").err, "--runs");
  EXPECT_EQ(run(question + " --stiffness 0.1").exit_code, 2);
}

TEST_F(Commands, aScoreWithoutErrorsTakesAllThreeSteps) {
  const json runs = jsonOf("score " + shipped("mockup.yaml") + " --truth " + shipped("mockup.yaml") +
                           " --runs 3 --seed 5 --unmodelled 0 --stiffness 0");
  EXPECT_LT(runs["via_point"]["mean_centring_error"], 0.01);
}

}  // namespace
}  // namespace tubeplan::app
