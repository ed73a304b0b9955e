#include "app/formats/arm/arm_reader.hpp"

#include <numbers>

#include "app/formats/arm/arm_numbers.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/parameters.hpp"
#include "tests/app/test_files.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

std::string cobraText() { return contentOf(shippedCells() / "cobra-arm.yaml"); }

ArmSource armOf(const std::string& text) { return readArm(parseYaml(text, "arm.yaml")); }

std::string refusal(const std::string& from, const std::string& to) {
  return messageOf([&] { (void)armOf(changed(cobraText(), from, to)); });
}

TEST(ArmReader, readsTheCobra) {
  const auto source = armOf(cobraText());
  const auto& arm = source.arm;
  ASSERT_EQ(arm.rows.size(), 6u);
  EXPECT_EQ(deflection::activeRows(arm), (std::vector<int>{2, 3, 4, 5}));
  const auto& platform = std::get<deflection::DenavitHartenberg<double>>(arm.rows[1].placement);
  EXPECT_DOUBLE_EQ(platform.alpha, -91.37 * kDegree);
  EXPECT_DOUBLE_EQ(platform.a, 15 * kInch);
  EXPECT_NEAR(arm.rows[5].joint_stiffness.z(), 5588 * kPound * kInch / kDegree, 1e-9);
  EXPECT_EQ(arm.rows[5].joint_stiffness.x(), deflection::kRigid);
  EXPECT_DOUBLE_EQ(arm.rows[3].weight.end, 20 * kPound);
  EXPECT_DOUBLE_EQ(arm.p_LT.y(), 7.8471 * kInch);
  ASSERT_TRUE(arm.rows[0].beam.has_value());
  EXPECT_NEAR(arm.rows[0].beam->E, 1.0121e7 * kPound / (kInch * kInch), 1);
  EXPECT_FALSE(source.names_tool_axis);
}

TEST(ArmReader, takesSpeedsPerSecondWhateverTheUnitOfTime) {
  const auto joint = armOf(cobraText()).arm.rows[2].joint;
  EXPECT_DOUBLE_EQ(joint.max_speed, 6 * kDegree);
  EXPECT_DOUBLE_EQ(joint.max_acceleration, 12 * kDegree);
}

TEST(ArmReader, readsJointsThatFollowOthers) {
  const std::string own =
      "{name: theta3, type: revolute, limits: [-155, 155], max_speed: 6, max_acceleration: 12, encoder_sigma: 0.002}";
  const std::string linked = "{name: theta3, type: revolute, follows: {theta1: 0.5, theta2: -1}, offset: 90}";
  const auto arm = armOf(changed(cobraText(), own, linked)).arm;
  EXPECT_EQ(deflection::activeRows(arm), (std::vector<int>{2, 3, 5}));
  ASSERT_EQ(arm.rows[4].joint.follows.size(), 2u);
  EXPECT_EQ(arm.rows[4].joint.follows[1].row, 3);
  EXPECT_EQ(arm.rows[4].joint.follows[1].ratio, -1);
  EXPECT_TRUE(deflection::findParameter(arm, "forearm.joint.offset").has_value());
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusal(own, changed(linked, from, to));
  };
  expectSays(with("theta1: 0.5", "theta9: 0.5"), "'theta9' is not a revolute joint with an encoder reading of its own");
  expectSays(with("theta1: 0.5", "theta3: 0.5"), "'theta3' is not a revolute joint with an encoder reading of its own");
  expectSays(with("theta1: 0.5", "theta1: half"), "number");
  expectSays(with("{theta1: 0.5, theta2: -1}", "{}"), "JOINT: RATIO");
  expectSays(with("offset: 90", "limits: [-1, 1]"), "limits");
}

TEST(ArmReader, readsOriginsPrismaticJointsLumpsAndTheAxis) {
  const auto arm = armOf(
                       "units: {length: mm, angle: deg, force: N}\nlinks:\n"
                       "  - name: rail\n    origin: {position: [0, 0, 100], rpy: [0, 90, 0]}\n"
                       "    joint: {name: s, type: prismatic, offset: 10, limits: [0, 500], max_speed: 50}\n"
                       "    beam: {E: 70000, Ix: 500, G: 26000, J: 900, segments: 4}\n"
                       "    weight: {lumps: [{weight: 3, at: [1, 2, 3]}]}\n"
                       "tool: {tip: [100, 0, 0], axis: [0, 3, 4], turn: {y: 0.5}}\nreference_temperature: 25\n")
                       .arm;
  EXPECT_DOUBLE_EQ(arm.rows[0].joint.offset, 0.01);
  EXPECT_DOUBLE_EQ(arm.rows[0].joint.upper, 0.5);
  EXPECT_DOUBLE_EQ(arm.rows[0].joint.max_speed, 0.05);
  EXPECT_NEAR(arm.rows[0].beam->E, 70e9, 1e-3);
  EXPECT_EQ(arm.rows[0].beam->segments, 4);
  EXPECT_DOUBLE_EQ(arm.rows[0].weight.lumps.at(0).at.z(), 0.003);
  EXPECT_TRUE(arm.tool_axis_L.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
  EXPECT_TRUE(arm.tool_turn_L.isApprox(Eigen::Vector3d(0, 0.5 * std::numbers::pi / 180, 0)));
  EXPECT_DOUBLE_EQ(arm.reference[deflection::Condition::kTemperature], 298.15);
}

TEST(ArmReader, refusesUnknownMissingAndIllTypedKeys) {
  expectSays(refusal("max_speed: 6", "maxspeed: 6"), "did you mean 'max_speed'?");
  expectSays(refusal("a: 13.202, ", ""), "no key 'a'");
  expectSays(refusal("alpha: 90, a: 0", "alpha: ninety, a: 0"), "'ninety'");
  expectSays(refusal("type: revolute", "type: revolving"), "revolute or prismatic");
  expectSays(refusal("dh: {alpha: 0, a: 26.406, d: 0}", "origin: {position: [0, 0], rpy: [0, 0, 0]}"), "three numbers");
  expectSays(refusal("{E: 1.0121e7, Iz: 0.394}", "{Iz: 0.394}"), "no E");
  expectSays(refusal("a: 0, d: 0, theta: 0}", "a: 0, d: 0}"), "'theta'");
}

TEST(ArmReader, refusesImpossibleArmsWithTheLine) {
  const std::string negative = refusal("{z: 5588}", "{z: -5588}");
  expectSays(negative, "arm.yaml:38:");
  expectSays(negative, "tool.joint_stiffness.z");
  expectSays(negative, "-5588");
  expectSays(refusal("a: 26.406", "a: 0"), "length zero");
  const std::string reversed = refusal("limits: [0, 180]", "limits: [180, 0]");
  expectSays(reversed, "latch-link.joint.limits");
  expectSays(reversed, "found 180, 0,");
  expectSays(refusal("name: forearm", "name: tool"), "another row");
  expectSays(refusal("gravity: [0, 0, -1]", "gravity: [0, 0, 0]"), "length zero");
}

// If one parameter is changed in the text by its dotted name, only this parameter must differ when the text is read
// again.
TEST(ArmReader, writesEveryParameterBack) {
  const std::string text = changed(cobraText(), "weight: {distributed: 0.126, end: 10.4}",
                                   "weight: {lumps: [{weight: 1, at: [0, 0, 1]}, {weight: 2, at: [1, 0, 0]}]}");
  const YamlNode root = parseYaml(text, "arm.yaml");
  const ArmSource source = readArm(root);
  const auto parameters = deflection::parametersOf(source.arm);
  ASSERT_GT(parameters.size(), 30u);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double value = parameters[i].value * 1.01 + 1e-3;
    const auto again =
        deflection::parametersOf(armOf(withArmParameters(text, root, source, {{parameters[i].name, value}})).arm);
    ASSERT_EQ(again.size(), parameters.size());
    for (std::size_t k = 0; k < again.size(); ++k)
      EXPECT_NEAR(again[k].value, k == i ? value : parameters[k].value, 1e-11 * (std::abs(value) + 1))
          << parameters[i].name;
  }
}

}  // namespace
}  // namespace tubeplan::app
