// `diagnose` finds a hidden effect, and the error falls when the effect is added to the cell and its parameters are
// fitted.
#include <nlohmann/json.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class EffectCommands : public ProgramTest {
 protected:
  [[nodiscard]] std::string bench() const { return (shippedCells() / "bench.yaml").string(); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }

  void simulate(const std::string& hide) {
    const auto outcome = run("simulate " + bench() + " --design bench --readings 120 --seed 7 --spread 0.1 --out " +
                             path("set") + (hide.empty() ? "" : " --hide " + hide));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

/// A cell with a known base and no free parameters is diagnosed like any other cell.
TEST_F(EffectCommands, AModelWithNothingFreeIsDiagnosed) {
  const std::string cell = contentOf(shippedCells() / "bench.yaml");
  write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
  write("held.yaml", cell.substr(0, cell.find("identify:")));
  for (const char* hidden : {"", "joint-scale@theta3:0.01", "backlash@tool.z:0.2deg"}) {
    ASSERT_EQ(run("simulate held.yaml --design bench --readings 60 --seed 5 --out set" +
                  (*hidden ? std::string(" --hide ") + hidden : ""))
                  .exit_code,
              0);
    const auto outcome = run("diagnose held.yaml set/measurements.csv --json -");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json found = json::parse(outcome.out);
    EXPECT_EQ(found["verdict"], *hidden ? "explained" : "adequate") << outcome.out;
    if (*hidden) {
      EXPECT_TRUE(std::string(hidden).starts_with(found["alternatives"][0][0]["effect"].get<std::string>() + "@"));
    }
    EXPECT_EQ(run("compare held.yaml set/measurements.csv").exit_code, *hidden ? 1 : 0);
  }
}

/// For measurements from a bench and another cell, whose base has another position and orientation, the verdict is
/// inconclusive.
TEST_F(EffectCommands, MeasurementsOfAnotherCellGetNoVerdict) {
  simulate("");
  const auto outcome = run("diagnose " + shipped("mockup.yaml") + " set/measurements.csv --json -");
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found["verdict"], "inconclusive");
  EXPECT_EQ(found["checks"][0]["severity"], "mistake");
  expectSays(found["checks"][0]["sentence"], "another cell");
  expectSays(found["checks"][0]["sentence"], "61");
  const auto compared = run("compare " + shipped("mockup.yaml") + " set/measurements.csv");
  EXPECT_EQ(compared.exit_code, 1);
  expectSays(compared.out, found["checks"][0]["sentence"].get<std::string>() + "; the error is");
  EXPECT_EQ(compared.out.find("falls-short"), std::string::npos) << compared.out;
  const auto identified = run("identify " + shipped("mockup.yaml") + " set/measurements.csv");
  EXPECT_EQ(identified.exit_code, outcome.exit_code);
  EXPECT_EQ(identified.out, run("diagnose " + shipped("mockup.yaml") + " set/measurements.csv").out);
  const auto refused = run("identify " + shipped("mockup.yaml") + " set/measurements.csv --out found.yaml");
  EXPECT_EQ(refused.exit_code, 1);
  expectSays(refused.out, "nothing was written");
  EXPECT_FALSE(std::filesystem::exists(folder / "found.yaml"));
}

/// For measurements of an arm with other stiffnesses, a fit of only the base is refused, because its residuals exceed
/// the noise; a fit with six free parameters is accepted.
TEST_F(EffectCommands, ABaseThatLeavesTheMeasurementsOffIsSaid) {
  ASSERT_EQ(
      run("simulate " + shipped("mockup-true.yaml") + " --design bowl --readings 40 --loads 0,30 --out set").exit_code,
      0);
  const std::string command = "identify " + shipped("mockup.yaml") + " set/measurements.csv --folds 0";
  const auto alone = run(command);
  EXPECT_EQ(alone.exit_code, 1) << alone.out << alone.err;
  expectSays(alone.out, "warning: the residuals are larger than noise explains");
  const auto freed =
      run(command +
          " --free tool.joint_stiffness.z,forearm.joint_stiffness.z,latch-link.beam.Iz,"
          "mezzanine-beam.beam.Iz,mezzanine-beam.joint_stiffness.z,mezzanine-platform.joint_stiffness.x");
  EXPECT_EQ(freed.exit_code, 0) << freed.err;
  EXPECT_EQ(freed.out.find("more than noise"), std::string::npos) << freed.out;
}

TEST_F(EffectCommands, EveryEffectOfTheCatalogueIsListedWithItsPlaces) {
  const auto all = run("effects " + bench());
  ASSERT_EQ(all.exit_code, 0) << all.err;
  for (const auto& kind : deflection::effectKinds()) expectSays("\n" + all.out, "\n" + std::string(kind.name) + "\n");
  const auto one = run("effects " + bench() + " backlash");
  expectSays(one.out, "gap (deg, usually up to 1.15)");
  expectSays(one.out, "tool.z");
  EXPECT_EQ(one.out.find("hysteresis"), std::string::npos);
  expectSays(run("effects " + bench() + " tool-remount").out, "at: a set-up of the readings, by its name");
  expectSays(run("effects " + bench() + " formula").out, "at: the formula's target: a joint");
  const json listed = json::parse(run("effects " + bench() + " --json -").out);
  for (const auto& effect : listed["effects"]) {
    EXPECT_NE(effect["words"], "") << effect["effect"];
    EXPECT_FALSE(effect["varies_with"].empty()) << effect["effect"];
    EXPECT_EQ(run("add " + bench() + " '" + effect["effect"].get<std::string>() + "@" +
                  effect["at"].get<std::string>() + "' --out " + path("better.yaml"))
                  .exit_code,
              0)
        << effect["effect"] << effect["at"];
  }
  const auto wrong = run("effects " + bench() + " backlsh");
  EXPECT_EQ(wrong.exit_code, 2);
  expectSays(wrong.err, "did you mean 'backlash'?");
}

TEST_F(EffectCommands, AHiddenEffectIsNamedAddedAndTheErrorFalls) {
  simulate("hysteresis@theta4:0.06deg");
  const std::string measurements = path("set/measurements.csv");
  const auto diagnosed = run("diagnose " + bench() + " " + measurements + " --json -");
  ASSERT_EQ(diagnosed.exit_code, 0) << diagnosed.err;
  const json answer = json::parse(diagnosed.out);
  EXPECT_EQ(answer["verdict"], "explained");
  ASSERT_EQ(answer["alternatives"].size(), 1U);
  EXPECT_EQ(answer["alternatives"][0][0]["effect"], "hysteresis");
  EXPECT_EQ(answer["alternatives"][0][0]["at"], "theta4");
  EXPECT_NEAR(answer["alternatives"][0][0]["parameters"]["half_width"]["value"].get<double>(), 0.06, 0.006);

  ASSERT_EQ(run("add " + bench() + " hysteresis@theta4 --out " + path("better.yaml")).exit_code, 0);
  const auto identified =
      run("identify " + path("better.yaml") + " " + measurements + " --out " + path("fitted.yaml") + " --json -");
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  const json found = json::parse(identified.out);
  EXPECT_LT(found["rms"]["heldout_after"].get<double>(), 1.1 * found["rms"]["noise_floor"].get<double>());

  const auto ladder = run("ladder " + measurements + " " + bench() + " " + path("fitted.yaml") + " --json -");
  ASSERT_EQ(ladder.exit_code, 0) << ladder.err;
  const json comparison = json::parse(ladder.out)["models"];
  EXPECT_GT(comparison[0]["rms"]["heldout"].get<double>(), 1.5 * comparison[1]["rms"]["heldout"].get<double>());

  // `diagnose` reads the fitted cell and finds no further effect.
  const auto again = json::parse(run("diagnose " + path("fitted.yaml") + " " + measurements + " --json -").out);
  EXPECT_TRUE(again["alternatives"].empty()) << again["sentence"];
}

TEST_F(EffectCommands, ImproveGoesThroughTheLoopByItself) {
  simulate("encoder-eccentricity@theta3:sine=0.05,cosine=0.08");
  const auto improved =
      run("improve " + bench() + " " + path("set/measurements.csv") + " --out " + path("improved.yaml") + " --json -");
  ASSERT_EQ(improved.exit_code, 0) << improved.err;
  const json figures = json::parse(improved.out);
  EXPECT_EQ(figures["steps"][0]["added"][0], "encoder-eccentricity@theta3");
  EXPECT_TRUE(figures["steps"].back()["added"].empty());
  EXPECT_LT(figures["models"].back()["rms"]["heldout"].get<double>(),
            1.1 * figures["models"].back()["rms"]["noise_floor"].get<double>());
  const Cell cell = readCell(path("improved.yaml"));
  ASSERT_EQ(cell.arm.effects.size(), 1U);
  EXPECT_NEAR(cell.arm.effects[0].values[1] / cell.units.factor(dimension::kAngle), 0.08, 0.01);
}

TEST_F(EffectCommands, TheTutorialDoesWhatItSays) {
  const std::string text = contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "docs/tutorial.md");
  int commands = 0;
  for (std::size_t at = text.find("\n    tubeplan "); at != std::string::npos;
       at = text.find("\n    tubeplan ", at + 1)) {
    const std::size_t from = at + std::string("\n    tubeplan ").size();
    std::string command = text.substr(from, text.find('\n', from) - from);
    for (std::size_t cell = command.find("app/cells/"); cell != std::string::npos;
         cell = command.find("app/cells/", cell + 99))
      command.replace(cell, std::string("app/cells").size(), shippedCells().string());
    const auto outcome = run(command);
    EXPECT_EQ(outcome.exit_code, command.starts_with("compare") ? 1 : 0) << command << outcome.err;
    if (command.starts_with("diagnose")) {
      EXPECT_TRUE(outcome.out.starts_with("explained")) << outcome.out;
    }
    ++commands;
  }
  EXPECT_EQ(commands, 12);
  for (const char* page : {"compare.html", "diagnose.html", "ladder.html", "steps.html"})
    EXPECT_TRUE(std::filesystem::exists(folder / page)) << page;
  const auto ladder = run("ladder campaign/measurements.csv " + shipped("mockup.yaml") +
                          " identified.yaml complete.yaml --rigid --truth real.yaml --json -");
  const json comparison = json::parse(ladder.out)["models"];
  ASSERT_EQ(comparison.size(), 4U);
  for (std::size_t k = 1; k < 4; ++k) {
    EXPECT_LT(comparison[k]["rms"]["heldout"], comparison[k - 1]["rms"]["heldout"]);
    EXPECT_LT(comparison[k]["steps"]["centring_error"]["p95"], comparison[k - 1]["steps"]["centring_error"]["p95"]);
  }
  EXPECT_GT(comparison[0]["steps"]["zero"], 700);
  EXPECT_GT(comparison[3]["steps"]["three"], comparison[2]["steps"]["three"]);
  EXPECT_EQ(comparison[3]["steps"]["zero"], 0);
}

TEST_F(EffectCommands, EffectsOfACellReachThePose) {
  ASSERT_EQ(run("add " + bench() + " joint-offset@theta2:1deg --out " + path("turned.yaml")).exit_code, 0);
  const auto turned = json::parse(run("pose " + path("turned.yaml") + " --joints=10,60,-70,5 --json -").out);
  const auto moved = json::parse(run("pose " + bench() + " --joints=10,61,-70,5 --json -").out);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(turned["flexible"]["position"][static_cast<std::size_t>(k)].get<double>(),
                moved["flexible"]["position"][static_cast<std::size_t>(k)].get<double>(), 1e-6);
}

TEST_F(EffectCommands, WrongNamesPlacesAndSizesAreRefused) {
  const auto refused = [&](const std::string& effect, const std::string& says) {
    const auto outcome = run("add " + bench() + " " + effect + " --out " + path("x.yaml"));
    EXPECT_EQ(outcome.exit_code, 2) << effect;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << effect << ": " << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("x.yaml")));
  };
  refused("backlsh@tool.z", "backlash");
  refused("backlash@tol.z", "tool.z");
  refused("backlash", "EFFECT@AT");
  refused("backlash@tool.z:0.1mm", "deg");
  refused("backlash@tool.z:-0.1", "from 0");
  refused("backlash@tool.z:gab=0.1", "gap");
}

TEST_F(EffectCommands, AFormulaIsAddedFittedAndSetBesideTheCatalogue) {
  const std::string formula = "'theta3 += c*sin(3*theta1)'";
  simulate("'theta3 += c*sin(3*theta1); c=0.08'");
  const std::string measurements = path("set/measurements.csv");
  const auto added = run("add " + bench() + " formula@theta3 --formula " + formula + " --out " + path("better.yaml"));
  ASSERT_EQ(added.exit_code, 0) << added.err;
  EXPECT_NE(added.out.find("freed formula@theta3.c"), std::string::npos) << added.out;
  const auto identified =
      run("identify " + path("better.yaml") + " " + measurements + " --out " + path("fitted.yaml") + " --json -");
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  const json found = json::parse(identified.out);
  const auto& numbers = found["parameters"];
  const auto c =
      std::find_if(numbers.begin(), numbers.end(), [](const json& n) { return n["name"] == "formula@theta3.c"; });
  ASSERT_NE(c, numbers.end());
  EXPECT_EQ((*c)["unit"], "deg");
  EXPECT_LE(std::abs((*c)["value"].get<double>() - 0.08), 3 * (*c)["sigma"].get<double>());
  EXPECT_LT((*c)["sigma"].get<double>(), 0.02);
  EXPECT_LT(found["rms"]["heldout_after"].get<double>(), 1.1 * found["rms"]["noise_floor"].get<double>());
  EXPECT_LT(found["rms"]["heldout_after"].get<double>(), 0.9 * found["rms"]["heldout_before"].get<double>());
  ASSERT_EQ(found["overlap"].size(), 1U);
  EXPECT_EQ(found["overlap"][0]["formula"], "formula@theta3");
  for (const auto& effect : found["overlap"][0]["effects"]) EXPECT_LT(effect["share"].get<double>(), 0.9) << effect;

  // The fitted cell is read back with its formula, and other commands accept it as their model.
  const Cell cell = readCell(path("fitted.yaml"));
  ASSERT_EQ(cell.arm.effects.size(), 1U);
  EXPECT_NEAR(cell.arm.effects[0].values[0] / cell.units.factor(dimension::kAngle), (*c)["value"].get<double>(), 1e-9);
  EXPECT_EQ(run("compare " + path("fitted.yaml") + " " + measurements).exit_code, 0);
  const auto diagnosed = run("diagnose " + path("fitted.yaml") + " " + measurements + " --json -");
  ASSERT_EQ(diagnosed.exit_code, 0) << diagnosed.err;
  EXPECT_TRUE(json::parse(diagnosed.out)["alternatives"].empty());
}

TEST_F(EffectCommands, AFormulaThatTheCatalogueHasIsNamed) {
  simulate("");
  const auto added = run("add " + bench() + " --formula 'theta4 += a*sin(2*theta4)' --readings " +
                         path("set/measurements.csv") + " --out " + path("better.yaml"));
  ASSERT_EQ(added.exit_code, 0) << added.err;
  EXPECT_NE(added.out.find("100 % of the rest is transmission-error at theta4"), std::string::npos) << added.out;
}

TEST_F(EffectCommands, AFormulaReachesThePose) {
  ASSERT_EQ(run("add " + bench() + " --formula 'theta2 += c*(theta1/pi*180 - 9); c=1' --out " + path("turned.yaml"))
                .exit_code,
            0);
  const auto turned = json::parse(run("pose " + path("turned.yaml") + " --joints=10,60,-70,5 --json -").out);
  const auto moved = json::parse(run("pose " + bench() + " --joints=10,61,-70,5 --json -").out);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(turned["flexible"]["position"][k].get<double>(), moved["flexible"]["position"][k].get<double>(), 1e-6);
}

TEST_F(EffectCommands, FormulasOfOneTargetGoRoundAFile) {
  ASSERT_EQ(run("add " + bench() + " --formula 'theta3 += c*sin(3*theta1)' --out " + path("one.yaml")).exit_code, 0);
  const auto second =
      run("add " + path("one.yaml") + " --formula 'theta3 += c*sin(k*theta1); k=5' --out " + path("two.yaml"));
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_NE(second.out.find("formula@theta3#2.c, formula@theta3#2.k"), std::string::npos) << second.out;
  const Cell cell = readCell(path("two.yaml"));
  ASSERT_EQ(cell.arm.effects.size(), 2U);
  EXPECT_EQ(deflection::textOf(cell.arm, cell.arm.effects[1]), "formula@theta3#2");
  EXPECT_EQ(cell.arm.effects[1].values[1], 5);
}

TEST_F(EffectCommands, WrongFormulasAreRefused) {
  const auto refused = [&](const std::string& formula, const std::string& says) {
    const auto outcome = run("add " + bench() + " --formula '" + formula + "' --out " + path("x.yaml"));
    EXPECT_EQ(outcome.exit_code, 2) << formula;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << formula << ": " << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("x.yaml")));
  };
  refused("theta3 += c*sin(3*thata1)", "did you mean 'theta1'?");
  refused("theta3 += c*sin(3*theta7)", "did you mean 'theta");
  refused("theta3 += c*laod", "did you mean 'load'?");
  refused("thetta3 += c*load", "did you mean 'theta3'?");
  refused("theta3 += c*sine(theta1)", "did you mean 'sin'?");
  refused("theta3 += c*sin(theta1", "character 23");
  refused("theta3 += c*sin(k*theta1)", "k=1");
  refused("", "EFFECT@AT");
  refused("theta3 += c*" + std::string(10000, '1'), "characters");
  EXPECT_EQ(run("add " + bench() + " formula@theta3 --out x.yaml").exit_code, 2);
  EXPECT_EQ(run("add " + bench() + " formula@theta2 --formula 'theta3 += c*load' --out x.yaml").exit_code, 2);
}

TEST_F(EffectCommands, AFormulaWithoutAValueAtAMeasurementNamesTheMeasurement) {
  simulate("");
  ASSERT_EQ(run("add " + bench() + " --formula 'theta3 += c/load' --out " + path("odd.yaml")).exit_code, 0);
  const std::string measurements = path("set/measurements.csv");
  for (const std::string command : {"identify ", "compare ", "diagnose "}) {
    const auto outcome = run(command + path("odd.yaml") + " " + measurements);
    EXPECT_EQ(outcome.exit_code, 2) << command << outcome.out;
    EXPECT_NE(outcome.err.find("measurements.csv:"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("load = 0"), std::string::npos) << outcome.err;
  }
  const auto pose = run("pose " + path("odd.yaml") + " --joints=10,60,-70,5");
  EXPECT_EQ(pose.exit_code, 2) << pose.out;
  EXPECT_NE(pose.err.find("load = 0"), std::string::npos) << pose.err;
}

}  // namespace
}  // namespace tubeplan::app
