// Tests of arms read from URDF and written back, joint by joint against the transforms that the file states.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <random>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/urdf/urdf_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/storage/input_question.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

const std::vector<std::string> kRobots{"ur5", "irb120", "panda", "iiwa14", "m10ia", "palletizer"};

std::string urdfText(const std::string& robot) {
  return contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/app/urdf" / (robot + ".urdf"));
}

Units metres() { return Units(parseYaml("units: {length: m, angle: deg, force: N}", "u.yaml").at("units")); }

VectorXd drawPosture(const deflection::Arm& arm, std::mt19937_64& random) {
  VectorXd q(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) {
    const auto& joint = arm.joint(k);
    q[k] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
  }
  return q;
}

Isometry3d poseOf(const urdf::Pose& pose) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() =
      Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z).toRotationMatrix();
  X.translation() << pose.position.x, pose.position.y, pose.position.z;
  return X;
}

/// Returns the frame of the only leaf link, from the file's transforms.
Isometry3d leafFrame(const urdf::ModelInterface& model, const std::map<std::string, double>& joints) {
  Isometry3d X = Isometry3d::Identity();
  for (auto link = model.getRoot(); !link->child_joints.empty();) {
    const auto joint = link->child_joints.front();
    X = X * poseOf(joint->parent_to_joint_origin_transform);
    const Vector3d axis(joint->axis.x, joint->axis.y, joint->axis.z);
    double value = 0;
    if (const auto found = joints.find(joint->name); found != joints.end()) value = found->second;
    if (joint->mimic) value = joint->mimic->multiplier * joints.at(joint->mimic->joint_name) + joint->mimic->offset;
    if (joint->type == urdf::Joint::PRISMATIC) X = X * Eigen::Translation3d(value * axis);
    if (joint->type == urdf::Joint::REVOLUTE) X = X * Eigen::AngleAxisd(value, axis);
    link = link->child_links.front();
  }
  return X;
}

void expectSameTips(const deflection::Arm& a, const deflection::Arm& b, std::mt19937_64& random, double tolerance) {
  for (int k = 0; k < 20; ++k) {
    const VectorXd q = drawPosture(a, random);
    const auto one = deflection::solveFlexibleKinematics(a, {q}), other = deflection::solveFlexibleKinematics(b, {q});
    EXPECT_LE((one.X_BD.p - other.X_BD.p).norm(), tolerance) << a.name;
    EXPECT_LE((one.X_BD.R * a.tool_axis_L - other.X_BD.R * b.tool_axis_L).norm(), tolerance) << a.name;
  }
}

TEST(Urdf, TipsAreWhereTheFileHasThem) {
  std::mt19937_64 random(1);
  for (const auto& robot : kRobots) {
    const deflection::Arm arm = parseUrdf(urdfText(robot), robot).arm;
    const auto model = urdf::parseURDF(urdfText(robot));
    for (int k = 0; k < 100; ++k) {
      const VectorXd q = drawPosture(arm, random);
      std::map<std::string, double> joints;
      for (Eigen::Index j = 0; j < arm.jointCount(); ++j) joints[arm.joint(j).name] = q[j];
      const auto tip = deflection::solveFlexibleKinematics(arm, {q}).X_BT;
      const Isometry3d X = leafFrame(*model, joints);
      EXPECT_LE((tip.p - X.translation()).norm(), 1e-12) << robot;
      EXPECT_LE((tip.R * arm.tool_axis_L - X.linear().col(2)).norm(), 1e-12) << robot;
    }
  }
}

TEST(Urdf, ExportedAndImportedAgainIsTheSameArm) {
  std::mt19937_64 random(2);
  for (const auto& robot : kRobots) {
    const deflection::Arm arm = parseUrdf(urdfText(robot), robot).arm;
    const deflection::Arm again = parseUrdf(urdfOf(arm).text, robot).arm;
    expectSameTips(arm, again, random, 1e-9);
    ASSERT_EQ(arm.jointCount(), again.jointCount());
    for (std::size_t k = 0; k < arm.rows.size(); ++k) {
      EXPECT_EQ(arm.rows[k].joint.name, again.rows[k].joint.name);
      EXPECT_DOUBLE_EQ(arm.rows[k].joint.lower, again.rows[k].joint.lower);
      Vector3d moment = Vector3d::Zero();
      for (const auto& lump : arm.rows[k].weight.lumps) moment += lump.weight * lump.at;
      for (const auto& lump : again.rows[k].weight.lumps) moment -= lump.weight * lump.at;
      EXPECT_LE(moment.norm(), 1e-9) << robot << " " << arm.rows[k].name;
    }
  }
}

TEST(Urdf, AnArmsFileReadsBackAsTheArm) {
  std::mt19937_64 random(3);
  for (const auto& robot : kRobots) {
    const deflection::Arm arm = parseUrdf(urdfText(robot), robot).arm;
    const deflection::Arm read = readArm(parseYaml(armYaml(arm, metres()), robot)).arm;
    expectSameTips(arm, read, random, 1e-9);
    EXPECT_TRUE(urdfOf(read).left_out.empty()) << robot << urdfOf(read).left_out.front();
  }
  for (const char* name : {"cobra-arm", "tsm-cobra-arm", "column-arm", "puma-arm", "iiwa-arm"}) {
    const auto source = readArm(parseYaml(contentOf(shippedCells() / (std::string(name) + ".yaml")), name));
    const auto again = readArm(parseYaml(armYaml(source.arm, source.units), name)).arm;
    expectSameTips(source.arm, again, random, 1e-9);
    for (const auto& parameter : deflection::parametersOf(source.arm)) {
      const auto same = deflection::findParameter(again, parameter.name);
      ASSERT_TRUE(same.has_value()) << parameter.name;
      EXPECT_NEAR(same->value, parameter.value, 1e-11 * std::max(1., std::abs(parameter.value))) << parameter.name;
    }
  }
}

TEST(Urdf, WeightsFollowersAndSolidsComeAlong) {
  const UrdfArm palletizer = parseUrdf(urdfText("palletizer"), "p.urdf");
  EXPECT_EQ(palletizer.arm.rows.back().joint.follows.front().ratio, -1);
  EXPECT_EQ(palletizer.arm.jointCount(), 4);
  EXPECT_NEAR(palletizer.arm.rows[2].weight.lumps.front().weight, 60 * 9.80665, 1e-9);
  const UrdfArm ur5 = parseUrdf(urdfText("ur5"), "ur5.urdf");
  ASSERT_EQ(ur5.shapes.size(), 3u);
  EXPECT_TRUE(ur5.shapes[0].text.starts_with("cylinder"));
  ASSERT_EQ(ur5.left_out.size(), 1u);
  expectSays(ur5.left_out[0], "moments of inertia");
}

// Unreadable text with percent signs must be refused; if it were the format of a message, %n would write to memory.
TEST(Urdf, APercentSignIsNoFormat) {
  for (const char* piece : {"%n%n%n%s%s%s", "&#37;n&#x25;n", "%1000000000d"}) {
    const std::string text = fmt::format(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"revolute\">"
        "<origin xyz=\"0 0 {}\"/><parent link=\"a\"/><child link=\"b\"/></joint></robot>",
        piece);
    EXPECT_NE(messageOf([&] { (void)parseUrdf(text, "p.urdf"); }), "") << piece;
  }
}

TEST(Urdf, RefusesWhatIsNoArm) {
  const std::string good = urdfText("palletizer");
  const auto refusal = [](const std::string& text, const std::string& tip = "") {
    return messageOf([&] { (void)parseUrdf(text, "p.urdf", tip); });
  };
  expectSays(refusal("hello"), "p.urdf");
  expectSays(refusal("<robot name=\"r\"/>"), "p.urdf");
  expectSays(refusal("<robot name=\"r\"><link name=\"only\"/></robot>"), "no moving joint");
  expectSays(refusal(good, "tool1"), "did you mean 'tool0'?");
  expectSays(refusal(changed(good, "type=\"prismatic\"", "type=\"floating\"")), "a floating joint");
  expectSays(refusal(changed(good, "mimic joint=\"upper\"", "mimic joint=\"uper\"")), "mimics 'uper'");
  expectSays(
      refusal("<robot name=\"r\"><link name=\"root\"/><link name=\"a\"/><link name=\"b\"/><link name=\"leaf\"/>"
              "<joint name=\"1\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/></joint>"
              "<joint name=\"2\" type=\"continuous\"><parent link=\"b\"/><child link=\"a\"/></joint>"
              "<joint name=\"3\" type=\"continuous\"><parent link=\"b\"/><child link=\"leaf\"/></joint></robot>"),
      "a closed loop");
  const std::string fork =
      "<link name=\"other\"/><joint name=\"o\" type=\"fixed\"><parent link=\"head\"/><child "
      "link=\"other\"/></joint></robot>";
  expectSays(refusal(changed(good, "</robot>", fork)), "--tip");
  EXPECT_EQ(parseUrdf(changed(good, "</robot>", fork), "p.urdf", "tool0").arm.rows.size(), 5u);
}

/// Returns the values of the choice that a refusal offers; empty if it offers none.
std::vector<std::string> tipsOffered(const std::string& text) {
  std::vector<std::string> tips;
  try {
    (void)parseUrdf(text, "r.urdf");
  } catch (const InputQuestion& question) {
    EXPECT_EQ(question.choice.name, "tip");
    for (const auto& value : question.choice.values) tips.push_back(value.value);
  } catch (const InputError&) {
  }
  return tips;
}

// A hand with two fingers, one of which follows the other: the tip cannot be guessed, and one finger cannot be it.
TEST(Urdf, OffersTheLinksThatCanBeTheTip) {
  const auto joint = [](const char* name, const char* type, const char* parent, const char* more = "") {
    return fmt::format(
        "<link name=\"{0}\"/><joint name=\"to_{0}\" type=\"{1}\"><parent link=\"{2}\"/><child link=\"{0}\"/>"
        "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/>{3}</joint>",
        name, type, parent, more);
  };
  const std::string arm = "<robot name=\"r\"><link name=\"base\"/>" + joint("arm", "revolute", "base") +
                          joint("hand", "fixed", "arm") + joint("centre", "fixed", "hand");
  const std::string left = joint("left", "prismatic", "hand"),
                    right = joint("right", "prismatic", "hand", "<mimic joint=\"to_left\"/>");
  EXPECT_EQ(tipsOffered(arm + left + right + "</robot>"), (std::vector<std::string>{"left", "centre", "hand", "arm"}));
  EXPECT_EQ(tipsOffered(arm + left + "</robot>"), std::vector<std::string>());  // the only end of the longest chain
  EXPECT_EQ(tipsOffered("<robot name=\"r\"><link name=\"only\"/></robot>"), std::vector<std::string>());
}

/// Returns a URDF with a revolute joint, a flange behind the joint, and the test's additions.
std::string flangeUrdf(const std::string& link = "", const std::string& more = "",
                       const std::string& joint = "<limit lower=\"-2\" upper=\"2\" effort=\"1\" velocity=\"1\"/>") {
  return "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\">" + link +
         "</link><link name=\"flange\"/><joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child "
         "link=\"arm\"/>"
         "<axis xyz=\"0 0 1\"/>" +
         joint +
         "</joint><joint name=\"f\" type=\"fixed\"><origin xyz=\"1 0 0\" rpy=\"0 1.5 0.5\"/><parent "
         "link=\"arm\"/><child "
         "link=\"flange\"/></joint>" +
         more + "</robot>";
}

constexpr const char* kMass = "<inertial><mass value=\"2\"/></inertial>";
constexpr const char* kBox = "<collision><geometry><box size=\"1 1 1\"/></geometry></collision>";

std::string refusalOf(const std::string& text, const std::string& tip = "") {
  return messageOf([&] { (void)parseUrdf(text, "r.urdf", tip); });
}

TEST(Urdf, WhatIsFixedBesideTheToolWeighsAndIsSolid) {
  const std::string camera =
      std::string("<link name=\"camera\">") + kMass + kBox +
      "</link><link name=\"tip\"/><joint name=\"c\" type=\"fixed\"><origin xyz=\"0 0 1\"/><parent "
      "link=\"flange\"/><child link=\"camera\"/></joint><joint name=\"t\" "
      "type=\"fixed\"><parent link=\"flange\"/><child link=\"tip\"/></joint>";
  const UrdfArm read = parseUrdf(flangeUrdf("", camera), "r.urdf", "tip");
  ASSERT_EQ(read.shapes.size(), 1u);
  ASSERT_EQ(read.arm.rows.back().weight.lumps.size(), 1u);
  EXPECT_NEAR(read.arm.rows.back().weight.lumps.front().weight, 2 * 9.80665, 1e-9);
  const Eigen::Vector3d expected = read.arm.p_LT + read.arm.R_LT.col(2);
  EXPECT_LE((read.arm.rows.back().weight.lumps.front().at - expected).norm(), 1e-12);
  EXPECT_EQ(read.tip, "tip");
}

TEST(Urdf, SolidsThatStandStillAreLeftOutInWords) {
  const std::string text =
      changed(flangeUrdf(), "<link name=\"base\"/>", std::string("<link name=\"base\">") + kBox + "</link>");
  const UrdfArm read = parseUrdf(text, "r.urdf");
  EXPECT_TRUE(read.shapes.empty());
  ASSERT_EQ(read.left_out.size(), 1u);
  expectSays(read.left_out[0], "link base, which does not move");
}

// A link must be read completely or refused; the only exceptions are those listed in `left_out`.
TEST(Urdf, NothingOfALinkIsLostUnsaid) {
  for (const std::string& harmless :
       {std::string(kMass) + kBox,
        std::string("<visual><geometry><capsule radius=\"1\"/></geometry></visual>") + kMass + kBox,
        std::string("<visual/>") + kMass + kBox,
        std::string("<inertial><mass value=\"2\"/><inertia ixx=\"1\"/></inertial>") + kBox}) {
    const UrdfArm read = parseUrdf(flangeUrdf(harmless), "r.urdf");
    EXPECT_EQ(read.shapes.size(), 1u) << harmless;
    EXPECT_EQ(read.arm.rows.front().weight.lumps.size(), 1u) << harmless;
  }
  const UrdfArm capsule = parseUrdf(
      flangeUrdf(std::string("<collision><geometry><capsule radius=\"1\" length=\"2\"/></geometry></collision>") +
                 kBox),
      "r.urdf");
  EXPECT_EQ(capsule.shapes.size(), 1u);
  expectSays(capsule.left_out.at(0), "the capsule of link arm");
  for (const char* wrong :
       {"<inertial><inertia ixx=\"1\"/></inertial>", "<inertial><mass value=\"-1\"/></inertial>",
        "<inertial><mass value=\"nan\"/></inertial>", "<inertial><origin xyz=\"a b c\"/><mass value=\"1\"/></inertial>",
        "<collision><geometry><box size=\"1 1\"/></geometry></collision>",
        "<collision><geometry><box/></geometry></collision>", "<collision><geometry><sphere/></geometry></collision>",
        "<collision><geometry><cylinder radius=\"1\"/></geometry></collision>",
        "<collision><geometry><mesh scale=\"1 1 1\"/></geometry></collision>",
        "<collision name=\"50%\"><origin xyz=\"1\"/><geometry><box size=\"1 1 1\"/></geometry></collision>"})
    EXPECT_NE(refusalOf(flangeUrdf(wrong)), "") << wrong;
}

// Angles that look like rounded multiples of 30 or 45 deg, or like degrees, must get a remark.
TEST(Urdf, AnglesThatLookWrongAreRemarkedOn) {
  struct Turn {
    std::string rpy, said;  // if `said` is empty, no remark is expected
  };
  for (const Turn& turn : {Turn{"0 0 3.141", "180 deg rounded"},
                           Turn{"1.57 0 0", "90 deg rounded"},
                           Turn{"0 -1.571 0", "-90 deg rounded"},
                           Turn{"0 0 -6.28", "-360 deg rounded"},
                           Turn{"90 0 0", "degrees"},
                           Turn{"0 0 -180", "degrees"},
                           Turn{"0 0 3.14159265", ""},
                           Turn{"1.5707963 0 0", ""},
                           Turn{"0.78 0.01 -0.3", ""},
                           Turn{"0.785 0.01 -0.3", "45 deg rounded"},
                           Turn{"0 2.094 0", "120 deg rounded"},
                           Turn{"0 0 -0.524", "-30 deg rounded"},
                           Turn{"3.1416 0 0", "turn the tool by up to 0.0073 mrad"},
                           Turn{"0 1.5708 0", "move its tip by up to 0.0025 mm"},
                           Turn{"0.7854 -0.7854 0", "up to 0.0037 mrad"},
                           Turn{"0 0 2.0944", "few digits"},
                           Turn{"0 0 3.141593", ""},
                           Turn{"0 0 0", ""},
                           Turn{"0 1.5 0", ""},
                           Turn{"1.5711 0 0.0003", ""},
                           Turn{"0 3.1402571 0", ""}}) {
    const std::string text =
        "<robot name='r'><link name='base'/><link name='a'/><link name='b'/><link name='tool'/>"
        "<joint name='j1' type='continuous'><parent link='base'/><child link='a'/><axis xyz='0 0 1'/></joint>"
        "<joint name='j2' type='continuous'><parent link='a'/><child link='b'/><origin xyz='0.7 0 0' rpy='" +
        turn.rpy +
        "'/><axis xyz='0 0 1'/></joint>"
        "<joint name='t' type='fixed'><parent link='b'/><child link='tool'/><origin xyz='0.6 0.1 "
        "0.3'/></joint></robot>";
    const UrdfArm read = parseUrdf(text, "r.urdf");
    ASSERT_EQ(read.remarks.size(), turn.said.empty() ? 0u : 1u) << turn.rpy;
    if (turn.said.empty()) continue;
    expectSays(read.remarks.front(), turn.said);
    expectSays(read.remarks.front(), "j2");
  }
}

// All joints up to the tip must be checked, including fixed joints of the tool; small deviations share one remark.
TEST(Urdf, RoundAnglesAreRemarkedOnOfEveryJoint) {
  const auto joint = [](int k, const char* type, const char* rpy) {
    return fmt::format(
        "<link name='l{0}'/><joint name='j{0}' type='{1}'><parent link='l{2}'/><child link='l{0}'/>"
        "<origin xyz='0 0 0.5' rpy='{3}'/><axis xyz='0 0 1'/></joint>",
        k, type, k - 1, rpy);
  };
  const UrdfArm read = parseUrdf("<robot name='r'><link name='l0'/>" + joint(1, "continuous", "3.141 0 0") +
                                     joint(2, "fixed", "0 1.571 0") + joint(3, "continuous", "0 0 1.5708") +
                                     joint(4, "fixed", "-1.57 0 0") + joint(5, "fixed", "3.1416 0 0") + "</robot>",
                                 "r.urdf");
  ASSERT_EQ(read.remarks.size(), 4u);
  for (const auto& [k, said] : {std::pair{0, "j1"}, {1, "j2"}, {2, "j4"}, {3, "joints j3, j5"}})
    expectSays(read.remarks[static_cast<std::size_t>(k)], said);
}

TEST(Urdf, NumbersOfOtherUnitsAreRemarkedOn) {
  const UrdfArm degrees = parseUrdf(flangeUrdf("", "", "<limit lower=\"-170\" upper=\"170\"/>"), "r.urdf");
  ASSERT_EQ(degrees.remarks.size(), 1u);
  expectSays(degrees.remarks[0], "degrees");
  const UrdfArm millimetres = parseUrdf(changed(flangeUrdf(), "xyz=\"1 0 0\"", "xyz=\"1000 0 0\""), "r.urdf");
  ASSERT_EQ(millimetres.remarks.size(), 1u);
  expectSays(millimetres.remarks[0], "millimetres");
  EXPECT_TRUE(parseUrdf(flangeUrdf("", "", "<limit lower=\"-12.566\" upper=\"12.566\"/>"), "r.urdf").remarks.empty());
}

struct WrongUrdf {
  std::string text, said;
};

/// Mistakes made by hand, by a converter or by an editor must be named with the line and the expected content.
TEST(Urdf, WhatIsWrongIsNamedWithItsLine) {
  const std::string good = flangeUrdf();
  const auto origin = [&](const char* text) { return changed(good, "xyz=\"1 0 0\"", text); };
  const auto limit = [](const char* text) { return flangeUrdf("", "", text); };
  const WrongUrdf wrongs[] = {
      {origin("xyz=\"0 0 ${height}\""), "convert xacro"},
      {origin("xyz=\"0 0 $(arg h)\""), "convert xacro"},
      {changed(good, "\"j\"", "\"${prefix}j\""), "convert xacro"},
      {origin("xyz=\"0 nan 1\""), "three numbers in m"},
      {origin("xyz=\"0 inf 1\""), "three numbers in m"},
      {origin("xyz=\"0 1e400 1\""), "three numbers in m"},
      {origin("xyz=\"0,0,1\""), "decimal point"},
      {origin("xyz=\"0 0 0,4\""), "decimal point"},
      {origin("xyz=\"0 1\""), "three numbers in m"},
      {origin("xyz=\"0 1 2 3\""), "three numbers in m"},
      {origin("xyz=\"\""), "three numbers in m"},
      {origin("xyz=\"0 0 400mm\""), "without units"},
      {origin("xzy=\"0 0 1\""), "did you mean 'xyz'?"},
      {changed(good, "rpy=\"0 1.5 0.5\"", "rpy=\"0 0 90deg\""), "three numbers in rad"},
      {changed(good, "xyz=\"0 0 1\"", "xyz=\"0 one 1\""), "a direction"},
      {changed(good, "xyz=\"0 0 1\"", "xyx=\"0 0 1\""), "did you mean 'xyz'?"},
      {changed(good, "revolute", "revolut"), "did you mean 'revolute'?"},
      {changed(good, "revolute", "spherical"), "the type 'spherical'"},
      {changed(good, " type=\"revolute\"", ""), "no type"},
      {changed(good, " name=\"j\"", ""), "the joint has no name"},
      {changed(good, "<link name=\"flange\"/>", "<link/>"), "the link has no name"},
      {changed(good, "name=\"f\"", "name=\"j\""), "a second joint 'j'"},
      {changed(good, "name=\"flange\"", "name=\"arm\""), "a second link 'arm'"},
      {changed(good, "<parent link=\"arm\"/>", ""), "no parent link"},
      {limit("<limit lower=\"nan\" upper=\"2\"/>"), "limit lower='nan'"},
      {limit("<limit lower=\"-pi\" upper=\"2\"/>"), "a number in rad or m"},
      {limit("<limit lower=\"-2\" upper=\"2\" velocity=\"-1\"/>"), "0 or more"},
      {limit("<limit lower=\"-2\" upper=\"2\"/><mimic joint=\"k\" multiplier=\"x\"/>"), "mimic multiplier"},
      {limit("<limit lower=\"-2\" upper=\"2\"/><mimic multiplier=\"2\"/>"), "the element mimic has no joint"},
      {changed(good, "<robot name=\"r\">", "<robot name=\"r\" version=\"2.0\">"), "URDF version '2.0'"},
      {flangeUrdf("<collision><geometry><cylinder radius=\"-1\" length=\"1\"/></geometry></collision>"), "a length"},
      {flangeUrdf("<inertial><origin rpy=\"0 0\"/><mass value=\"1\"/></inertial>"), "three numbers in rad"},
      {changed(good, "</joint>", "</jont>"), "tags do not match"},
      {good.substr(0, good.size() / 2), "breaks off"},
      {changed(good, "<robot name=\"r\">", "<robot>"), "the robot has no name"},
  };
  for (const auto& wrong : wrongs) {
    const std::string message = refusalOf("<?xml version=\"1.0\"?>\n" + wrong.text);
    expectSays(message, wrong.said);
    expectSays(message, "r.urdf:2");
  }
  expectSays(refusalOf("<sdf version=\"1.6\"/>"), "found the root element <sdf>, expected <robot>");
  expectSays(refusalOf("<robot name=\"r\"/>"), "no links");
}

/// Values that the reader does not use must be accepted in any notation.
TEST(Urdf, NumbersOfAControllerArePassedOver) {
  EXPECT_EQ(
      parseUrdf(flangeUrdf("", "", "<limit lower=\"-2\" upper=\"+2\" effort=\"inf\"/>"), "r.urdf").arm.joint(0).upper,
      2);
}

TEST(Urdf, ClosedChainsAreRefused) {
  const std::string second = "<joint name=\"k\" type=\"fixed\"><parent link=\"base\"/><child link=\"flange\"/></joint>";
  expectSays(refusalOf(flangeUrdf("", second)), "'flange' is also the child of the joint");
  expectSays(refusalOf(flangeUrdf("", "<link name=\"alone\"/>")), "not the child of any joint");
  const std::string ring = "<joint name=\"k\" type=\"fixed\"><parent link=\"flange\"/><child link=\"base\"/></joint>";
  expectSays(refusalOf(flangeUrdf("", ring)), "a closed loop");
}

TEST(Urdf, LimitsAndAxesAreReadOrRefused) {
  const auto limits = [](const char* text) { return parseUrdf(flangeUrdf("", "", text), "r.urdf"); };
  EXPECT_EQ(limits("<limit lower=\"-2\" upper=\"1\" effort=\"0\" velocity=\"3\"/>").arm.joint(0).upper, 1);
  EXPECT_EQ(limits("<limit lower=\"-2\"\n upper=\"1\"/>").arm.joint(0).lower, -2);
  const UrdfArm none = limits("<limit effort=\"1\" velocity=\"1\"/>");
  EXPECT_FALSE(std::isfinite(none.arm.joint(0).upper));
  expectSays(none.left_out.at(0), "limits of joint j");
  for (const char* wrong :
       {"<limit lower=\"0.5\" upper=\"-0.5\"/>", "<limit lower=\"0.3\" upper=\"0.3\"/>", "<limit lower=\"0.5\"/>", ""})
    EXPECT_NE(refusalOf(flangeUrdf("", "", wrong)), "") << wrong;
  expectSays(refusalOf(changed(flangeUrdf(), "0 0 1\"/>", "0 0 0\"/>")), "length zero");
  EXPECT_EQ(parseUrdf(changed(flangeUrdf(), "0 0 1\"/>", "0\n0\t1\"/>"), "r.urdf").arm.jointCount(), 1);
  expectSays(refusalOf(changed(flangeUrdf(), "rpy=\"0 1.5 0.5\"", "quat_xyzw=\"0 0 0 1\"")), "quat_xyzw");
}

// Settings of a joint's controller must be reported as ignored, and the arm must have the hard limits.
TEST(Urdf, WhatControllersAreToldIsSaid) {
  const std::string joint =
      "<limit lower=\"-2\" upper=\"2\" effort=\"1\" velocity=\"1\"/><calibration rising=\"0.25\"/>"
      "<safety_controller soft_lower_limit=\"-1.75\" soft_upper_limit=\"1.5\" k_velocity=\"1\"/>";
  const std::string motor =
      "<transmission name=\"t\"><joint name=\"j\"><offset>0.125</offset></joint>"
      "<actuator name=\"m\"><mechanicalReduction>-80</mechanicalReduction></actuator></transmission>";
  const UrdfArm read = parseUrdf(flangeUrdf("", motor, joint), "r.urdf");
  EXPECT_EQ(read.arm.joint(0).lower, -2);
  EXPECT_EQ(read.arm.joint(0).upper, 2);
  ASSERT_EQ(read.left_out.size(), 3U);
  expectSays(read.left_out[0], "j -1.75 to 1.5");
  expectSays(read.left_out[1], "j rising 0.25");
  expectSays(read.left_out[2], "j offset 0.125 mechanicalReduction -80");
  EXPECT_TRUE(parseUrdf(flangeUrdf(), "r.urdf").left_out.empty());
}

TEST(Urdf, TheToolFrameIsTheTipLinks) {
  const UrdfArm read = parseUrdf(flangeUrdf(), "r.urdf");
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.5, Vector3d::UnitZ()) * Eigen::AngleAxisd(1.5, Vector3d::UnitY())).toRotationMatrix();
  EXPECT_LE((read.arm.R_LT - turn).norm(), 1e-12);
  const auto again = readArm(parseYaml(armYaml(read.arm, metres()), "arm")).arm;
  EXPECT_LE((again.R_LT - turn).norm(), 1e-11);  // angles are written with twelve digits
  EXPECT_LE((parseUrdf(urdfOf(read.arm).text, "r.urdf").arm.R_LT - turn).norm(), 1e-12);
}

TEST(Urdf, AFollowerMayFollowAFollower) {
  const auto joint = [](const char* name, const char* parent, const char* child, const char* mimic) {
    return fmt::format(
        "<link name=\"{2}\"/><joint name=\"{0}\" type=\"continuous\"><parent link=\"{1}\"/><child "
        "link=\"{2}\"/><axis xyz=\"0 0 1\"/>{3}</joint>",
        name, parent, child, mimic);
  };
  const std::string text =
      changed(flangeUrdf(), "</robot>",
              joint("b", "flange", "two", "<mimic joint=\"j\" multiplier=\"2\" offset=\"0.25\"/>") +
                  joint("c", "two", "three", "<mimic joint=\"b\" multiplier=\"3\" offset=\"0.5\"/>") + "</robot>");
  const UrdfArm read = parseUrdf(text, "r.urdf");
  const auto& third = read.arm.rows.back().joint;
  ASSERT_EQ(third.follows.size(), 1u);
  EXPECT_EQ(third.follows.front().row, 0);
  EXPECT_EQ(third.follows.front().ratio, 6);
  EXPECT_DOUBLE_EQ(third.offset, 1.25);
  expectSays(refusalOf(changed(text, "mimic joint=\"j\"", "mimic joint=\"c\"")), "mimics");
}

TEST(Urdf, RowsMayHaveTheNamesThatAnExportGives) {
  deflection::Arm arm = parseUrdf(flangeUrdf(), "r.urdf").arm;
  arm.rows.front().name = "tip";
  arm.rows.front().joint.name = "tip";
  EXPECT_EQ(parseUrdf(urdfOf(arm).text, "r.urdf").arm.rows.front().name, "tip");
  arm.rows.front().name = "base";
  EXPECT_EQ(parseUrdf(urdfOf(arm).text, "r.urdf").arm.rows.front().name, "base");
}

}  // namespace
}  // namespace tubeplan::app
