// Arms out of URDF and back, beside the transforms that the file itself states, joint by joint.
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <random>

#include "app/files/arm_reader.hpp"
#include "app/files/arm_writer.hpp"
#include "app/files/cell_reader.hpp"
#include "app/files/urdf_reader.hpp"
#include "app/files/urdf_writer.hpp"
#include "app/files/yaml/strict_yaml.hpp"
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

/// The frame of the only leaf by the file's own transforms.
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
    expectSameTips(arm, readArm(parseYaml(armYaml(arm, metres()), robot)).arm, random, 1e-9);
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

// urdfdom gives the coordinate that it cannot read to printf as its format: %n would write into memory.
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
  expectSays(refusal(changed(good, "type=\"prismatic\"", "type=\"floating\"")), "floating or planar");
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

}  // namespace
}  // namespace tubeplan::app
