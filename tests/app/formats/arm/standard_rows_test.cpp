// Tests of arm files in the standard Denavit-Hartenberg convention.
#include <gtest/gtest.h>

#include <regex>

#include "app/formats/arm/arm_numbers.hpp"
#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/effects/rigid_frames.hpp"
#include "deflection/parameters.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

/// The same arm twice: a standard table as printed by makers, and the modified (Craig) table converted by hand.
struct BothTables {
  const char* name;
  const char* standard;
  const char* modified;
};

constexpr const char* kUnitsLine = "units: {length: m, angle: deg, force: N}\n";
constexpr const char* kToolLine = "tool: {tip: [0.01, 0.02, 0.1]}\n";

const BothTables kTables[] = {
    {"a cobot of three parallel axes",
     "- {name: base, dh: {alpha: 90, a: 0, d: 0.15, theta: 0}, joint: {name: q1, type: revolute}}\n"
     "- {name: shoulder, dh: {alpha: 0, a: -0.6, d: 0, theta: 0}, joint: {name: q2, type: revolute}}\n"
     "- {name: elbow, dh: {alpha: 0, a: -0.55, d: 0, theta: 0}, joint: {name: q3, type: revolute}}\n"
     "- {name: wrist1, dh: {alpha: 90, a: 0, d: 0.17, theta: 0}, joint: {name: q4, type: revolute}}\n"
     "- {name: wrist2, dh: {alpha: -90, a: 0, d: 0.12, theta: 0}, joint: {name: q5, type: revolute}}\n"
     "- {name: wrist3, dh: {alpha: 0, a: 0, d: 0.11, theta: 0}, joint: {name: q6, type: revolute}}\n",
     "- {name: base, dh: {alpha: 0, a: 0, d: 0.15}, joint: {name: q1, type: revolute}}\n"
     "- {name: shoulder, dh: {alpha: 90, a: 0, d: 0}, joint: {name: q2, type: revolute}}\n"
     "- {name: elbow, dh: {alpha: 0, a: -0.6, d: 0}, joint: {name: q3, type: revolute}}\n"
     "- {name: wrist1, dh: {alpha: 0, a: -0.55, d: 0.17}, joint: {name: q4, type: revolute}}\n"
     "- {name: wrist2, dh: {alpha: 90, a: 0, d: 0.12}, joint: {name: q5, type: revolute}}\n"
     "- {name: wrist3, dh: {alpha: -90, a: 0, d: 0.11}, joint: {name: q6, type: revolute}}\n"},
    {"an arm with a spherical wrist",
     "- {name: waist, dh: {alpha: -90, a: 0, d: 0}, joint: {name: q1, type: revolute}}\n"
     "- {name: shoulder, dh: {alpha: 0, a: 0.43, d: 0.15}, joint: {name: q2, type: revolute, offset: 10}}\n"
     "- {name: elbow, dh: {alpha: 90, a: -0.02, d: 0}, joint: {name: q3, type: revolute}}\n"
     "- {name: roll, dh: {alpha: -90, a: 0, d: 0.43}, joint: {name: q4, type: revolute}}\n"
     "- {name: bend, dh: {alpha: 90, a: 0, d: 0}, joint: {name: q5, type: revolute}}\n"
     "- {name: flange, dh: {alpha: 30, a: 0.05, d: 0.06}, joint: {name: q6, type: revolute}}\n",
     "- {name: waist, dh: {alpha: 0, a: 0, d: 0}, joint: {name: q1, type: revolute}}\n"
     "- {name: shoulder, dh: {alpha: -90, a: 0, d: 0.15}, joint: {name: q2, type: revolute, offset: 10}}\n"
     "- {name: elbow, dh: {alpha: 0, a: 0.43, d: 0}, joint: {name: q3, type: revolute}}\n"
     "- {name: roll, dh: {alpha: 90, a: -0.02, d: 0.43}, joint: {name: q4, type: revolute}}\n"
     "- {name: bend, dh: {alpha: -90, a: 0, d: 0}, joint: {name: q5, type: revolute}}\n"
     "- {name: flange, dh: {alpha: 90, a: 0, d: 0.06}, joint: {name: q6, type: revolute}}\n"
     "- {name: end, dh: {alpha: 30, a: 0.05, d: 0, theta: 0}}\n"},
};

std::string fileOf(const std::string& rows, const std::string& convention = "") {
  return kUnitsLine + convention + "links:\n" + rows + kToolLine;
}

std::string standardFile(const std::string& rows) { return fileOf(rows, "convention: standard\n"); }

ArmSource armOfText(const std::string& text) { return readArm(parseYaml(text, "arm.yaml")); }

double tipDistance(const deflection::Arm& one, const deflection::Arm& other) {
  double most = 0;
  for (int n = 0; n < 20; ++n) {
    Eigen::VectorXd q(one.jointCount());
    for (Eigen::Index k = 0; k < q.size(); ++k) q[k] = std::sin(1.7 * n + 2.3 * static_cast<double>(k));
    const auto a = deflection::rigidFramesOf<double>(one, q), b = deflection::rigidFramesOf<double>(other, q);
    most = std::max({most, (a.tip - b.tip).norm(), (a.rows.back().R - b.rows.back().R).norm()});
  }
  return most;
}

TEST(StandardRows, areTheArmOfCraigsTable) {
  for (const auto& [name, standard, modified] : kTables) {
    const ArmSource source = armOfText(standardFile(standard));
    EXPECT_LE(tipDistance(source.arm, armOfText(fileOf(modified)).arm), 1e-12) << name;
    EXPECT_GT(tipDistance(source.arm, armOfText(fileOf(standard)).arm), 0.1) << name;
    const std::string again = armYaml(source.arm, source.units);
    EXPECT_EQ(occurrences(again, "convention: standard"), 1u);
    EXPECT_EQ(occurrences(again, "- name: "), 6u) << again;
    EXPECT_LE(tipDistance(source.arm, armOfText(again).arm), 1e-12) << name;
  }
  EXPECT_LE(tipDistance(armOfText(fileOf(kTables[0].modified)).arm,
                        armOfText(fileOf(kTables[0].modified, "convention: modified\n")).arm),
            0);
}

TEST(StandardRows, everyParameterIsWrittenBackWhereItStands) {
  for (const auto& [name, rows, modified] : kTables) {
    const std::string text = standardFile(rows);
    const YamlNode root = parseYaml(text, "arm.yaml");
    const ArmSource source = readArm(root);
    for (const auto& parameter : deflection::parametersOf(source.arm)) {
      if (parameter.name.find(".dh.") == std::string::npos && parameter.name.find(".axis.") == std::string::npos)
        continue;
      const double value = parameter.value + 0.01;
      const std::string changed_text = withArmParameters(text, root, source, {{parameter.name, value}});
      const ArmSource again = armOfText(changed_text);
      const auto found = deflection::findParameter(again.arm, parameter.name);
      ASSERT_TRUE(found.has_value()) << parameter.name;
      EXPECT_NEAR(found->value, value, 1e-12) << parameter.name;
      deflection::Arm moved = source.arm;
      deflection::locate(moved, parameter.path) = value;
      EXPECT_LE(tipDistance(again.arm, moved), 1e-12) << parameter.name;
      EXPECT_EQ(occurrences(changed_text, "convention: standard"), 1u);
    }
  }
}

/// A first joint axis other than the base's z axis must be read as in the first row of Craig's table, and be kept when
/// the arm is written.
TEST(StandardRows, aFirstAxisMayStandElsewhere) {
  const std::string axis = "axis: {alpha: 0.4, a: 0.003, beta: -0.2, b: -0.002}";
  for (const auto& [name, standard, modified] : kTables) {
    const std::string first_of_standard = standard, first_of_modified = modified;
    const std::string text =
        standardFile(changed(first_of_standard, "joint: {name: q1,", axis + ", joint: {name: q1,"));
    const std::string craigs =
        fileOf(changed(first_of_modified, "dh: {alpha: 0, a: 0,", "dh: {alpha: 0.4, a: 0.003, beta: -0.2, b: -0.002,"));
    const ArmSource source = armOfText(text);
    EXPECT_LE(tipDistance(source.arm, armOfText(craigs).arm), 1e-12) << name;
    const std::string again = armYaml(source.arm, source.units);
    EXPECT_EQ(occurrences(again, "axis: {"), 1u) << again;
    EXPECT_LE(tipDistance(source.arm, armOfText(again).arm), 1e-12) << name;
  }
}

TEST(StandardRows, anAxisOfOtherLinksIsRefused) {
  const std::string rows = kTables[0].standard, axis = "axis: {a: 0.1}, joint: {name: ";
  const auto refusal = [](const std::string& text) { return messageOf([&] { (void)armOfText(text); }); };
  const std::string first = changed(rows, "joint: {name: q1", axis + "q1");
  const std::string second = changed(rows, "joint: {name: q2", axis + "q2");
  const std::string foot = "- {name: foot, origin: {position: [0, 0, 1], rpy: [0, 0, 90]}}\n";
  for (const std::string& text : {fileOf(first), standardFile(second), fileOf(second), standardFile(foot + first)})
    expectSays(refusal(text), "`axis` is only for a first link with `dh` under `convention: standard`");
  expectSays(refusal(standardFile(changed(first, "axis: {a: 0.1}", "axis: {d: 0.1}"))), "the unknown key 'd'");
}

TEST(StandardRows, whatTheyCannotBeIsRefused) {
  const std::string rows = kTables[0].standard;
  const auto refusal = [](const std::string& text) { return messageOf([&] { (void)armOfText(text); }); };
  expectSays(refusal(fileOf(rows, "convention: craig\n")), "standard or modified");
  const std::string mixed =
      changed(rows, "dh: {alpha: 0, a: -0.55, d: 0, theta: 0}", "origin: {position: [1, 0, 0], rpy: [0, 0, 0]}");
  expectSays(refusal(standardFile(mixed)), "a row with `origin` follows a row with `dh`");
  const std::string wrong = refusal(standardFile(changed(rows, "a: -0.6", "a: .inf")));
  expectSays(wrong, "arm.yaml:5");
}

TEST(StandardRows, originsMayComeFirst) {
  const std::string foot = "- {name: foot, origin: {position: [0, 0, 1], rpy: [0, 0, 90]}}\n";
  const auto with = armOfText(standardFile(foot + kTables[0].standard)).arm;
  const auto same = armOfText(fileOf(foot + kTables[0].modified)).arm;
  EXPECT_LE(tipDistance(with, same), 1e-12);
}

}  // namespace
}  // namespace tubeplan::app
