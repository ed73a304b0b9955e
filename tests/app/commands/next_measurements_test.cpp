// A diagnosis proposes further measurements only if several causes remain possible, and warns of wrong effects in the
// cell.
#include <nlohmann/json.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class NextMeasurements : public ProgramTest {
 protected:
  [[nodiscard]] std::string bench() const { return (shippedCells() / "bench.yaml").string(); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }

  void simulate(const std::string& hide, const std::string& size = "--readings 60") {
    const auto outcome = run("simulate " + bench() + " --design bench " + size + " --seed 7 --out " + path("set") +
                             (hide.empty() ? "" : " --hide " + hide));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  [[nodiscard]] json answer(const std::string& arguments) const {
    const auto outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
};

bool hasKind(const json& warnings, const std::string& kind) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const json& warning) { return warning.is_object() && warning["kind"] == kind; });
}

TEST_F(NextMeasurements, AreProposedWhereTheAnswerIsOneOfSeveral) {
  // A tool that bends sideways is hard to distinguish from a compliant joint that carries the tool.
  simulate("link-bending@tool.z:1e-6", "--readings 120 --spread 0.1");
  const json diagnosed = answer("diagnose " + bench() + " " + path("set/measurements.csv") + " --next 4");
  ASSERT_EQ(diagnosed["verdict"], "ambiguous") << diagnosed["sentence"];
  const json& discrimination = diagnosed["splitting"];
  EXPECT_FALSE(discrimination["pairs"].empty());
  EXPECT_NE(diagnosed["sentence"].get<std::string>().find(discrimination["advice"].get<std::string>()),
            std::string::npos);
  if (discrimination["can_be_split"].get<bool>()) {
    ASSERT_EQ(diagnosed["next_readings"].size(), 4U);
    const auto arm = readCell(bench()).arm;
    for (const auto& measurement : diagnosed["next_readings"]) {
      EXPECT_EQ(measurement["posture"].size(), 4U);
      EXPECT_EQ(measurement["senses"].size(), 4U);
      EXPECT_EQ(measurement["splits"].size(), 2U);
      EXPECT_NE(measurement["splits"][0], measurement["splits"][1]);
      EXPECT_GE(measurement["separation_sigmas"], 0);
      EXPECT_TRUE(measurement["point"].is_null());
      const double theta2 = measurement["posture"]["theta2"];
      const auto& joint = arm.joint(1);
      EXPECT_GE(theta2, joint.lower / 0.017453292519943295 - 1e-6);
      EXPECT_LE(theta2, joint.upper / 0.017453292519943295 + 1e-6);
    }
  } else {
    EXPECT_TRUE(diagnosed["next_readings"].empty());
    EXPECT_FALSE(discrimination["other_means"].empty());
  }
}

TEST_F(NextMeasurements, AreNoneWhereTheVerdictLeavesNothingOpen) {
  simulate("hysteresis@theta4:0.06deg");
  const json diagnosed = answer("diagnose " + bench() + " " + path("set/measurements.csv"));
  EXPECT_EQ(diagnosed["verdict"], "explained");
  EXPECT_TRUE(diagnosed["next_readings"].empty());
  EXPECT_FALSE(diagnosed.contains("splitting"));
  EXPECT_TRUE(diagnosed["warnings"].empty());
}

TEST_F(NextMeasurements, AWrongEffectInTheCellIsWarnedOfByBothCommands) {
  simulate("hysteresis@theta4:0.06deg");
  ASSERT_EQ(run("add " + bench() + " backlash@tool.z --out " + path("wrong.yaml")).exit_code, 0);
  ASSERT_EQ(run("add " + bench() + " hysteresis@theta4 --out " + path("right.yaml")).exit_code, 0);
  const std::string measurements = path("set/measurements.csv");
  const json wrong = answer("identify " + path("wrong.yaml") + " " + measurements);
  EXPECT_TRUE(hasKind(wrong["warnings"], "misfit-remains")) << wrong["warnings"];
  EXPECT_TRUE(answer("identify " + path("right.yaml") + " " + measurements)["warnings"].empty());
  const json diagnosed = answer("diagnose " + path("wrong.yaml") + " " + measurements);
  EXPECT_TRUE(hasKind(diagnosed["warnings"], "not-needed") || hasKind(diagnosed["warnings"], "better-explained-by"))
      << diagnosed["warnings"];
  for (const auto& warning : diagnosed["warnings"]) {
    EXPECT_EQ(warning["effect"], "backlash");
    EXPECT_EQ(warning["at"], "tool.z");
    if (warning["kind"] != "better-explained-by") continue;
    EXPECT_EQ(warning["better"]["effect"], "hysteresis");
  }
  EXPECT_TRUE(answer("diagnose " + path("right.yaml") + " " + measurements)["warnings"].empty());
}

}  // namespace
}  // namespace tubeplan::app
