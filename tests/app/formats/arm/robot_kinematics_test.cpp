#include "app/formats/arm/robot_kinematics.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <variant>

#include "app/documents/arm_figures.hpp"
#include "app/formats/arm/arm_reader.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

const std::string kKinematics =
    "kinematics:\n"
    "  shoulder:\n    x: 0\n    y: 0\n    z: 0.1521\n    roll: -0\n    pitch: 0\n    yaw: -1.5e-05\n"
    "  upper_arm: {x: -0.0001, y: 0, z: 0, roll: 1.5703, pitch: 0, yaw: 2.0e-05}\n"
    "  forearm: {x: -0.2441, y: 0, z: 0, roll: 0.002, pitch: -0.001, yaw: 1.0e-05}\n"
    "  wrist_1: {x: -0.2130, y: -0.0002, z: 0.1312, roll: 0.0015, pitch: 0, yaw: 3.0e-05}\n"
    "  wrist_2: {x: 0.0001, y: -0.0854, z: 0.0001, roll: 1.5709, pitch: 0, yaw: -2.0e-05}\n"
    "  wrist_3: {x: 0, y: 0.0921, z: 0, roll: 1.5706, pitch: 3.14159, yaw: -3.1415}\n"
    "  hash: calib_1234567890\n";

/// A Universal Robots arm; the first row is turned by 180 deg about z, as below the root link of the arm's URDF.
const std::string kArm =
    "# drawn\nunits: {length: mm, angle: deg, force: N}\nlinks:\n"
    "  - {name: s, origin: {position: [0, 0, 151.9], rpy: [0, 0, 180]}, joint: {name: q1, type: revolute}}\n"
    "  - {name: u, origin: {position: [0, 0, 0], rpy: [90, 0, 0]}, joint: {name: q2, type: revolute}}\n"
    "  - {name: f, origin: {position: [-243.65, 0, 0], rpy: [0, 0, 0]}, joint: {name: q3, type: revolute}}\n"
    "  - {name: w1, origin: {position: [-213, 0, 131.05], rpy: [0, 0, 0]}, joint: {name: q4, type: revolute}}\n"
    "  - {name: w2, origin: {position: [0, -85.35, 0], rpy: [90, 0, 0]}, joint: {name: q5, type: revolute}}\n"
    "  - {name: w3, origin: {position: [0, 92.1, 0], rpy: [90, 180, 180]}, joint: {name: q6, type: revolute}}\n"
    "tool: {tip: [0, 0, 100]}  # measured\n";

YamlFile calibratedArmOf(const std::string& text) { return {"arm.yaml", text, parseYaml(text, "arm.yaml")}; }
RobotKinematics kinematicsOf(const std::string& text) { return readRobotKinematics(parseYaml(text, "ur.yaml")); }

TEST(RobotKinematics, replacesTheOriginsAndKeepsTheHalfTurnOfTheBase) {
  const RobotKinematics kinematics = kinematicsOf(kKinematics);
  EXPECT_EQ(kinematics.hash, "calib_1234567890");
  const std::string text = withRobotKinematics(calibratedArmOf(kArm), kinematics);
  expectSays(text, "# measured");
  const ArmSource found = readArm(parseYaml(text, "found.yaml"));
  ASSERT_EQ(found.arm.rows.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& origin = std::get<deflection::Origin<double>>(found.arm.rows[k].placement);
    auto expected = kinematics.origins[k];
    if (k == 0) expected.rpy.z() += std::numbers::pi;
    EXPECT_NEAR((origin.position - expected.position).norm(), 0, 1e-12) << k;
    EXPECT_NEAR((origin.rpy - expected.rpy).norm(), 0, 2e-11) << k;  // 180 deg is written with twelve digits
  }
  const std::string as_root = changed(kArm, "rpy: [0, 0, 180]}, joint: {name: q1", "rpy: [0, 0, 0]}, joint: {name: q1");
  const ArmSource straight =
      readArm(parseYaml(withRobotKinematics(calibratedArmOf(as_root), kinematics), "found.yaml"));
  EXPECT_NEAR(std::get<deflection::Origin<double>>(straight.arm.rows[0].placement).rpy.z(), -1.5e-5, 1e-15);
}

TEST(RobotKinematics, comeBackFromTextToTheLastBit) {
  for (const std::string& text : {kKinematics, changed(kKinematics, "  hash: calib_1234567890\n", "")}) {
    const RobotKinematics read = kinematicsOf(text), again = kinematicsOf(robotKinematicsText(read));
    EXPECT_EQ(again.hash, read.hash);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_EQ(again.origins[k].position, read.origins[k].position) << k;
      EXPECT_EQ(again.origins[k].rpy, read.origins[k].rpy) << k;
    }
  }
}

TEST(RobotKinematics, ofAnArmAreThoseThatItWasGivenWhicheverWayItsBaseStands) {
  const RobotKinematics given = kinematicsOf(kKinematics);
  for (const char* yaw : {"180", "0"}) {
    const std::string arm = changed(kArm, "rpy: [0, 0, 180]}, joint: {name: q1",
                                    std::string("rpy: [0, 0, ") + yaw + "]}, joint: {name: q1");
    const ArmSource calibrated = readArm(parseYaml(withRobotKinematics(calibratedArmOf(arm), given), "found.yaml"));
    const RobotKinematics again = robotKinematicsOf(calibrated.arm, "found.yaml");
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR((again.origins[k].position - given.origins[k].position).norm(), 0, 1e-12) << yaw << k;
      EXPECT_NEAR((again.origins[k].rpy - given.origins[k].rpy).norm(), 0, 2e-11) << yaw << k;
    }
  }
}

/// The origins of an identified arm must include its joint offsets, tilts and passive rows, so that the tip does not
/// move.
TEST(RobotKinematics, ofAnIdentifiedArmHoldItsOffsetsLeansAndPassiveRows) {
  const std::string text =
      changed(changed(changed(kArm, "{name: q2, type: revolute}", "{name: q2, type: revolute, offset: 3}"),
                      "rpy: [0, 0, 0]}, joint: {name: q3", "rpy: [0, 0, 0], beta: 2}, joint: {name: q3"),
              "  - {name: w1,", "  - {name: flange, origin: {position: [5, 6, 7], rpy: [1, 2, 3]}}\n  - {name: w1,");
  const deflection::Arm arm = readArm(parseYaml(text, "arm.yaml")).arm;
  deflection::Arm plain = readArm(parseYaml(kArm, "arm.yaml")).arm;
  RobotKinematics kinematics = robotKinematicsOf(arm, "arm.yaml");
  kinematics.origins[0].position.head<2>() *= -1;  // restores the half turn of the base
  kinematics.origins[0].rpy.z() += std::numbers::pi;
  for (std::size_t k = 0; k < 6; ++k) plain.rows[k].placement = kinematics.origins[k];
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(6, -1, 2);
  const auto tip = [&](const deflection::Arm& of) { return deflection::solveFlexibleKinematics(of, {q}).X_BD.p; };
  EXPECT_NEAR((tip(arm) - tip(plain)).norm(), 0, 1e-12);
}

TEST(RobotKinematics, ofOtherArmsAreRefused) {
  const auto of = [](const std::string& text) {
    return robotKinematicsOf(readArm(parseYaml(text, "arm.yaml")).arm, "arm.yaml");
  };
  EXPECT_THROW((void)of(changed(kArm, ", joint: {name: q6, type: revolute}", "")), InputError);
  EXPECT_THROW((void)of(changed(kArm, "{name: q6, type: revolute}", "{name: q6, type: prismatic}")), InputError);
  EXPECT_THROW(
      (void)of(changed(kArm, "origin: {position: [-243.65, 0, 0], rpy: [0, 0, 0]}", "dh: {alpha: 0, a: 1, d: 0}")),
      InputError);
}

TEST(RobotKinematics, whatTheFileLacksIsNamed) {
  const struct {
    const char *from, *to, *says;
  } kWrong[] = {{"  wrist_2: {", "  wrist_two: {", "wrist_2"},
                {"yaw: 1.0e-05}", "yawn: 1.0e-05}", "ur.yaml:10"},
                {"z: 0.1312, ", "", "'z'"},
                {"z: 0.1312", "z: 0,1312", "ur.yaml:11"},
                {"0.1312", "thirteen", "thirteen"},
                {"kinematics:", "calibration:", "kinematics"}};
  for (const auto& [from, to, says] : kWrong)
    expectSays(messageOf([&, &f = from, &t = to] { (void)kinematicsOf(changed(kKinematics, f, t)); }), says);
  EXPECT_EQ(kinematicsOf(changed(kKinematics, "  hash: calib_1234567890\n", "")).hash, "");
}

TEST(RobotKinematics, anArmThatItIsNotOfIsRefused) {
  const auto kinematics = kinematicsOf(kKinematics);
  const struct {
    const char *from, *to, *says;
  } kWrong[] = {
      {"position: [-243.65, 0, 0]", "position: [-425, 0, 0]", "'f' would move by 180.9 mm"},
      {"position: [0, -85.35, 0], rpy: [90, 0, 0]", "position: [0, -85.35, 0], rpy: [-90, 0, 0]", "'w2'"},
      {"joint: {name: q4, type: revolute}", "joint: {name: q4, type: revolute, offset: 5}", "'w1'"},
      {"joint: {name: q4, type: revolute}", "joint: {name: q4, type: prismatic}", "'w1'"},
      {", joint: {name: q4, type: revolute}", "", "found 5 joints"},
      {"origin: {position: [0, 92.1, 0], rpy: [90, 180, 180]}", "dh: {alpha: 90, a: 0, d: 92.1}", "'w3' has `dh`"},
  };
  for (const auto& [from, to, says] : kWrong)
    expectSays(messageOf([&, &f = from, &t = to] {
                 (void)withRobotKinematics(calibratedArmOf(changed(kArm, f, t)), kinematics);
               }),
               says);
  const std::string two = changed(changed(kArm, "-213, 0, 131.05", "-392, 0, 109"), "-243.65, 0", "-425, 0");
  expectSays(messageOf([&] { (void)withRobotKinematics(calibratedArmOf(two), kinematics); }), "'f'");
}

TEST(ArmText, showsOriginsAsTheFileHasThem) {
  const ArmSource source = readArm(parseYaml(kArm, "arm.yaml"));
  const std::string text = armText(source.arm, source.units);
  expectSays(text, "origin of w1: position -213, 0, 131.05 mm, rpy 0, 0, 0 deg");
  expectSays(text, "origin of w3: position 0, 92.1, 0 mm, rpy 90, 180, 180 deg");
  EXPECT_EQ(occurrences(text, "origin of "), 6u);
  const std::string by_dh =
      changed(kArm, "origin: {position: [0, 92.1, 0], rpy: [90, 180, 180]}", "dh: {alpha: 90, a: 0, d: 92.1}");
  const ArmSource mixed = readArm(parseYaml(by_dh, "arm.yaml"));
  EXPECT_EQ(occurrences(armText(mixed.arm, mixed.units), "origin of "), 5u);
}

}  // namespace
}  // namespace tubeplan::app
