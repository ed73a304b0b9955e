// Tests of arms written back into their URDF: every link must have the arm's frame, computed from the file's own
// transforms, and all other bytes must be unchanged.
#include "app/formats/urdf/urdf_edit.hpp"

#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <random>
#include <regex>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/chain.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using deflection::Arm;
using Eigen::Isometry3d, Eigen::Vector3d;

/// Makes URDF texts of random robots that contain all elements of the format, not only kinematics, in different
/// notations.
class RobotMaker {
 public:
  explicit RobotMaker(int seed) : random_(static_cast<unsigned>(seed)) {}

  std::string make() {
    text_ =
        "<?xml version=\"1.0\"?>\n<!-- <joint name=\"j0\"><origin xyz=\"9 9 9\"/></joint> -->\n<robot name='r'>\n"
        "  <material name=\"m\"><color rgba=\"1 0 0 1\"/></material>\n";
    addLink("base");
    const int count = integer(3, 8);
    for (int k = 0; k < count; ++k) {
      if (k > 0 && integer(0, 2) == 0) addJoint("fixed", "");
      const bool follows = k > 1 && !slides_.back() && !slides_.front() && integer(0, 4) == 0;
      const bool slides = !follows && integer(0, 4) == 0;
      addJoint(slides ? "prismatic" : integer(0, 1) == 0 ? "continuous" : "revolute", follows ? leader_ : "");
      slides_.push_back(slides);
      if (slides_.size() == 1) leader_ = last_joint_;
    }
    for (int k = integer(0, 2); k > 0; --k) addJoint("fixed", "");
    return text_ +
           "  <transmission name=\"t\"><joint name=\"j0\"><origin xyz=\"1 1 1\"/></joint></transmission>\n"
           "  <ros2_control name=\"c\" type=\"system\"><joint name=\"j1\"><limit lower='7'/></joint></ros2_control>\n"
           "  <gazebo reference=\"base\"><![CDATA[ </robot> <joint> ]]></gazebo>\t \n</robot>\n<!-- end -->";
  }

 private:
  int integer(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  double draw(double size) {
    return std::round(std::uniform_real_distribution<double>(-size, size)(random_) * 1e4) / 1e4;
  }
  std::string three(double size) { return fmt::format("{} {}  {}", draw(size), draw(size), draw(size)); }

  void addLink(const std::string& name) {
    text_ += fmt::format(
        "  <link name=\"{0}\">\n\t<visual><origin xyz='{1}' rpy=\"{2}\"/><geometry><mesh "
        "filename=\"package://r/{0}.dae\"/></geometry><material name=\"m\"/></visual>\n"
        "    <inertial> <origin xyz=\"{1}\"/><mass value=\"1.50\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" "
        "iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/></inertial>\n  </link>\n",
        name, three(0.2), three(3));
    last_link_ = name;
  }

  std::string origin() {
    switch (integer(0, 4)) {
      case 0:
        return "";
      case 1:
        return fmt::format("\n    <origin xyz = '{}' />", three(0.6));
      case 2:
        return fmt::format("\n    <!-- <origin/> --><origin rpy=\"{}\"></origin>", three(3));
      default:
        return fmt::format("\n    <origin rpy=\"{}\"\n      xyz=\"{}\"/>  <!-- measured -->", three(3), three(0.6));
    }
  }

  void addJoint(const std::string& type, const std::string& leader) {
    const std::string parent = last_link_, number = std::to_string(count_++);
    last_joint_ = (type == "fixed" ? "f" : "j") + number + (count_ == 2 ? " &amp; &lt;" : "");
    addLink("l" + number);
    text_ += fmt::format("  <joint name=\"{}\" type='{}'>{}\n    <parent link=\"{}\"/><child link=\"l{}\"/>",
                         last_joint_, type, origin(), parent, number);
    if (type != "fixed") text_ += fmt::format("<axis xyz=\"{}\"/>", three(1));
    if (type != "fixed") text_ += "\n    <limit lower=\"-1.50\" effort=\"1\" upper=\"+1.5\" velocity=\"2\"/>";
    if (!leader.empty())
      text_ += fmt::format("<mimic joint=\"{}\" multiplier=\"-0.5\" offset=\"{}\"/>", leader, draw(1));
    text_ += "\n  </joint>\n";
  }

  std::mt19937_64 random_;
  std::string text_, last_link_, last_joint_, leader_;
  std::vector<bool> slides_;
  int count_ = 0;
};

/// Returns the arm after `arm import` has written it to a file and another command has read the file.
Arm throughFile(const Arm& arm) {
  const Units units(parseYaml("units: {length: m, angle: deg, force: N}", "u.yaml").at("units"));
  return readArm(parseYaml(armYaml(arm, units), "arm.yaml")).arm;
}

/// Returns the arm, read from a file, with random calibration errors; `moved` receives the joints whose origins change.
Arm withCalibration(const UrdfArm& read, std::mt19937_64& random, std::vector<std::string>& moved) {
  Arm arm = throughFile(read.arm);
  const auto draw = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
  const auto drawn = [&](double size) { return Vector3d(draw(size), draw(size), draw(size)); };
  std::vector<bool> is_moved(arm.rows.size());
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    auto& row = arm.rows[k];
    const bool has_offset = draw(1) > 0 && !row.joint.name.empty(), has_origin = draw(1) > 0.3;
    if (has_offset) row.joint.offset += draw(0.02);
    auto& origin = std::get<deflection::Origin<double>>(row.placement);
    if (has_origin) origin = {origin.position + drawn(0.01), origin.rpy + drawn(0.01)};
    is_moved[k] = has_offset || has_origin;
    for (const auto& followed : row.joint.follows)
      is_moved[k] = is_moved[k] || arm.rows[static_cast<std::size_t>(followed.row)].joint.offset != 0;
    if (is_moved[k]) moved.push_back(read.joints[k].name);
  }
  if (draw(1) > 0) {
    arm.p_LT += drawn(0.01);
    arm.R_LT = arm.R_LT * Eigen::AngleAxisd(0.01, Vector3d::UnitX());
    arm.tool_axis_L = arm.R_LT.col(2);
    if (read.joints.size() > read.arm.rows.size()) moved.push_back(read.joints.back().name);
  }
  return arm;
}

Isometry3d poseOfUrdf(const urdf::Pose& pose) {
  const Eigen::Quaterniond turn(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * turn;
}

double valueOfJoint(const urdf::ModelInterface& model, const urdf::Joint& joint,
                    const std::map<std::string, double>& measurements) {
  if (!joint.mimic) return measurements.at(joint.name);
  const double leading = valueOfJoint(model, *model.getJoint(joint.mimic->joint_name), measurements);
  return joint.mimic->multiplier * leading + joint.mimic->offset;
}

/// Returns the frame of a link relative to the root link, from the file's transforms.
Isometry3d linkFrameAt(const urdf::ModelInterface& model, const std::string& name,
                       const std::map<std::string, double>& measurements) {
  const auto joint = model.getLink(name)->parent_joint;
  if (!joint) return Isometry3d::Identity();
  Isometry3d X =
      linkFrameAt(model, joint->parent_link_name, measurements) * poseOfUrdf(joint->parent_to_joint_origin_transform);
  if (joint->type == urdf::Joint::FIXED) return X;
  const Vector3d axis = Vector3d(joint->axis.x, joint->axis.y, joint->axis.z).normalized();
  const double value = valueOfJoint(model, *joint, measurements);
  if (joint->type == urdf::Joint::PRISMATIC) return X * Eigen::Translation3d(value * axis);
  return X * Eigen::AngleAxisd(value, axis);
}

/// Returns the frames of the arm's rows and of the tool relative to the base, from the arm's parameters.
std::vector<Isometry3d> framesOf(const Arm& arm, const Eigen::VectorXd& q) {
  std::vector<Isometry3d> frames;
  Isometry3d X = Isometry3d::Identity();
  Eigen::Index joint = 0;
  for (const auto& row : arm.rows) {
    const bool reads = row.joint.type != deflection::JointType::kPassive;
    const double value = row.joint.offset + (reads ? q[joint++] : deflection::followedAngle<double>(arm, row.joint, q));
    X.translate(deflection::offsetInPreviousAxes(row)).rotate(deflection::rotationFromPrevious(row));
    if (row.joint.type == deflection::JointType::kPrismatic)
      X.translate(value * Vector3d::UnitZ());
    else
      X.rotate(Eigen::AngleAxisd(value, Vector3d::UnitZ()));
    frames.push_back(X);
  }
  frames.push_back(X.translate(arm.p_LT).rotate(arm.R_LT));
  return frames;
}

/// Expects every link and the tool tip of the text to agree with the arm at random joint readings.
void expectLinksWhereTheArmHasThem(const std::string& text, const UrdfArm& before, const Arm& arm,
                                   std::mt19937_64& random) {
  const auto model = urdf::parseURDF(text);
  ASSERT_TRUE(model);
  const std::string tip = before.joints.size() > before.arm.rows.size() || !model->getLink("tip") ? before.tip : "tip";
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::VectorXd q(arm.jointCount());
    std::map<std::string, double> measurements;
    for (Eigen::Index k = 0; k < q.size(); ++k)
      measurements[arm.joint(k).name] = q[k] = std::uniform_real_distribution<double>(-2, 2)(random);
    const auto frames = framesOf(arm, q);
    for (std::size_t k = 0; k < arm.rows.size(); ++k) {
      const Isometry3d X = frames[k] * before.joints[k].X_CL.inverse();
      EXPECT_LE((linkFrameAt(*model, arm.rows[k].name, measurements).matrix() - X.matrix()).norm(), 1e-9)
          << arm.rows[k].name;
    }
    EXPECT_LE((linkFrameAt(*model, tip, measurements).matrix() - frames.back().matrix()).norm(), 1e-9) << text;
  }
}

/// Returns the text without the origins of these joints and without an added tip.
std::string withoutOrigins(std::string text, const std::vector<std::string>& joints) {
  for (std::string name : joints) {
    name = std::regex_replace(std::regex_replace(name, std::regex("&"), "&amp;"), std::regex("<"), "&lt;");
    const std::size_t from = text.find("  <joint name=\"" + name + "\" type="), to = text.find("</joint>", from);
    EXPECT_NE(to, std::string::npos) << name;
    const std::string block = text.substr(from, to - from);
    text.replace(from, to - from, std::regex_replace(block, std::regex(R"(\s*<origin\s[^>]*>)"), ""));
  }
  const std::size_t added = text.find("  <link name=\"tip\"/>");
  if (added != std::string::npos) text.erase(added, text.find("</joint>\n", added) + 9 - added);
  return text;
}

TEST(UrdfEdit, AnUnchangedArmLeavesEveryByte) {
  for (int seed = 0; seed < 40; ++seed) {
    const std::string text = RobotMaker(seed).make();
    const UrdfEdit edit = withArmInUrdf(text, "r.urdf", "", throughFile(parseUrdf(text, "r.urdf").arm));
    EXPECT_EQ(edit.text, text) << seed;
    EXPECT_TRUE(edit.changed.empty()) << seed << edit.changed.front();
    EXPECT_TRUE(edit.left_out.empty()) << seed << edit.left_out.front();
  }
}

TEST(UrdfEdit, AChangedArmMovesItsOriginsAndNothingElse) {
  for (int seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(static_cast<unsigned>(seed));
    const std::string text = RobotMaker(seed).make();
    const UrdfArm read = parseUrdf(text, "r.urdf");
    std::vector<std::string> moved;
    const Arm arm = withCalibration(read, random, moved);
    const UrdfEdit edit = withArmInUrdf(text, "r.urdf", "", throughFile(arm));
    expectLinksWhereTheArmHasThem(edit.text, read, arm, random);
    EXPECT_EQ(withoutOrigins(edit.text, moved), withoutOrigins(text, moved)) << seed;
    const UrdfEdit again = withArmInUrdf(edit.text, "r.urdf", "", throughFile(parseUrdf(edit.text, "r.urdf").arm));
    EXPECT_EQ(again.text, edit.text) << seed;
    if (HasFailure()) return;
  }
}

TEST(UrdfEdit, PublishedRobotsKeepTheirBytes) {
  for (const char* robot : {"ur5", "irb120", "panda", "iiwa14", "m10ia", "palletizer"}) {
    const std::string text =
        contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/app/urdf" / (std::string(robot) + ".urdf"));
    Arm arm = throughFile(parseUrdf(text, robot).arm);
    EXPECT_EQ(withArmInUrdf(text, robot, "", arm).text, text) << robot;
    arm.rows[1].joint.offset = 0.01;
    const UrdfEdit edit = withArmInUrdf(text, robot, "", arm);
    EXPECT_EQ(std::ranges::count(edit.text, '\n'), std::ranges::count(text, '\n')) << robot;
    EXPECT_FALSE(edit.changed.empty());
  }
}

/// Robot with a prismatic joint along y and a revolute joint about x; the tip is the second joint's child link.
constexpr const char* kTwoJoints =
    "\xEF\xBB\xBF<robot name=\"r\">\r\n  <link name=\"base\"/>\r\n"
    "  <link name=\"a\"><inertial><mass value=\"2\"/></inertial></link>\r\n  <link name=\"b\"/>\r\n"
    "  <joint name=\"slide\" type=\"prismatic\">\r\n    <origin xyz=\"0 0 0.4\"/><parent link=\"base\"/><child "
    "link=\"a\"/><axis xyz=\"0 1 0\"/><limit lower=\"0\" upper=\"0.5\" effort=\"1\" velocity=\"1\"/>\r\n  </joint>\r\n"
    "  <joint name=\"elbow\" type=\"continuous\">\r\n    <parent link=\"a\"/><child link=\"b\"/><origin xyz=\"1 0 0\" "
    "rpy=\"0 0 3.5\"/><axis xyz=\"1 0 0\"/>\r\n  </joint>\r\n</robot>\r\n";

TEST(UrdfEdit, OffsetsMoveOriginsAlongAndAboutTheirOwnAxes) {
  Arm arm = throughFile(parseUrdf(kTwoJoints, "r.urdf").arm);
  arm.rows[0].joint.offset = 0.003;
  EXPECT_EQ(withArmInUrdf(kTwoJoints, "r.urdf", "", arm).text, changed(kTwoJoints, "0 0 0.4", "0 0.003 0.4"));
  arm.rows[0].joint.offset = 0;
  arm.rows[1].joint.offset = 0.25;
  const UrdfEdit edit = withArmInUrdf(kTwoJoints, "r.urdf", "", arm);
  EXPECT_EQ(edit.text, changed(kTwoJoints, "0 0 3.5", "0.25 0 3.5"));  // the angles nearest to the written angles
  ASSERT_EQ(edit.changed.size(), 1u);
  expectSays(edit.changed[0], "elbow");
  expectSays(edit.changed[0], "turned 250 mrad");
}

TEST(UrdfEdit, ANameMayStandOnTwoLines) {
  const std::string text = changed(kTwoJoints, "\"elbow\"", "\"el\nbow\"");
  Arm arm = throughFile(parseUrdf(text, "r.urdf").arm);
  arm.rows[1].joint.offset = 0.25;
  EXPECT_EQ(withArmInUrdf(text, "r.urdf", "", arm).text, changed(text, "0 0 3.5", "0.25 0 3.5"));
}

TEST(UrdfEdit, ATipWithoutAFixedJointIsAdded) {
  Arm arm = throughFile(parseUrdf(kTwoJoints, "r.urdf").arm);
  arm.p_LT = {0, 0, 0.2};
  const UrdfEdit edit = withArmInUrdf(kTwoJoints, "r.urdf", "", arm);
  const std::size_t end = std::string(kTwoJoints).find("</robot>");
  EXPECT_EQ(edit.text.substr(0, end), std::string(kTwoJoints).substr(0, end));
  EXPECT_EQ(occurrences(edit.text, "\r\n"), occurrences(edit.text, "\n"));
  const UrdfArm again = parseUrdf(edit.text, "r.urdf");
  EXPECT_EQ(again.tip, "tip");
  EXPECT_LE((again.arm.p_LT - arm.p_LT).norm(), 1e-12);
}

TEST(UrdfEdit, LimitsAreChangedWhereTheFileHasThem) {
  Arm arm = throughFile(parseUrdf(kTwoJoints, "r.urdf").arm);
  arm.rows[0].joint.upper = 0.45;
  const UrdfEdit edit = withArmInUrdf(kTwoJoints, "r.urdf", "", arm);
  EXPECT_EQ(edit.text, changed(kTwoJoints, "upper=\"0.5\"", "upper=\"0.45\""));
  EXPECT_TRUE(edit.left_out.empty());
  arm.rows[1].joint.lower = -1;
  arm.rows[1].joint.upper = 1;
  EXPECT_EQ(withArmInUrdf(kTwoJoints, "r.urdf", "", arm).text, edit.text);
  EXPECT_EQ(withArmInUrdf(kTwoJoints, "r.urdf", "", arm).left_out.size(), 2u);  // both limits of a continuous joint
}

TEST(UrdfEdit, WhatUrdfCannotSayIsLeftOutInWords) {
  const Arm plain = throughFile(parseUrdf(kTwoJoints, "r.urdf").arm);
  struct Beyond {
    std::function<void(Arm&)> change;
    const char* said;
  };
  for (const Beyond& beyond : {
           Beyond{[](Arm& arm) { arm.rows[1].joint_stiffness.z() = 1e4; }, "stiffnesses"},
           Beyond{[](Arm& arm) { arm.rows[0].weight.lumps[0].weight *= 1.1; }, "the masses in"},
           Beyond{[](Arm& arm) { arm.gravity_W = Vector3d::UnitX(); }, "gravity"},
           Beyond{[](Arm& arm) {
                    arm.side_chains.push_back({0, {arm.rows[0]}});
                  },
                  "side chains"},
           Beyond{[](Arm& arm) { arm.effects.push_back(deflection::makeEffect(arm, "backlash", "b.z").effect); },
                  "backlash@b.z"},
       }) {
    Arm arm = plain;
    beyond.change(arm);
    const UrdfEdit edit = withArmInUrdf(kTwoJoints, "r.urdf", "", arm);
    EXPECT_EQ(edit.text, kTwoJoints) << beyond.said;
    ASSERT_EQ(edit.left_out.size(), 1u) << beyond.said;
    expectSays(edit.left_out[0], beyond.said);
  }
}

TEST(UrdfEdit, AnArmOfAnotherRobotIsRefused) {
  const Arm plain = throughFile(parseUrdf(kTwoJoints, "r.urdf").arm);
  const auto refusal = [&](auto change) {
    Arm arm = plain;
    change(arm);
    return messageOf([&] { (void)withArmInUrdf(kTwoJoints, "r.urdf", "", arm); });
  };
  expectSays(refusal([](Arm& arm) { arm.rows[1].joint.name = "knee"; }), "knee");
  expectSays(refusal([](Arm& arm) { arm.rows.pop_back(); }), "--tip");
  expectSays(refusal([](Arm& arm) { arm.rows[1].joint.type = deflection::JointType::kPrismatic; }), "elbow");
  expectSays(messageOf([&] { (void)withArmInUrdf("<robot name=\"r\"", "r.urdf", "", plain); }), "XML");
}

TEST(UrdfEdit, OfSeveralTipsTheNamedOneMoves) {
  const auto tip = [](const char* name) {
    return fmt::format(
        "<link name=\"{0}\"/><joint name=\"to_{0}\" type=\"fixed\"><parent link=\"b\"/><child link=\"{0}\"/><origin "
        "xyz=\"0 0 1\"/></joint>",
        name);
  };
  const std::string text = changed(kTwoJoints, "</robot>", tip("left") + tip("right") + "</robot>");
  Arm arm = throughFile(parseUrdf(text, "r.urdf", "right").arm);
  arm.p_LT += 0.5 * arm.tool_axis_L;
  expectSays(messageOf([&] { (void)withArmInUrdf(text, "r.urdf", "", arm); }), "--tip");
  EXPECT_EQ(withArmInUrdf(text, "r.urdf", "right", arm).text,
            changed(text, tip("right"), changed(tip("right"), "0 0 1\"", "0 0 1.5\"")));
}

}  // namespace
}  // namespace tubeplan::app
