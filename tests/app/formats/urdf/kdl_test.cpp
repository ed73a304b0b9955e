// Tests of arms read from URDF against Orocos KDL, whose own parser builds a chain from the same file; the two share no
// code.
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <random>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/units.hpp"
#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/urdf/urdf_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

constexpr int kPostures = 200;
constexpr double kSame = 1e-9;  // tolerance of positions [m] and axis components

/// A robot, and the number of its joints that have a measurement.
struct KdlRobot {
  const char* name;
  int joints;
};
void PrintTo(const KdlRobot& robot, std::ostream* out) { *out << robot.name; }

class AgainstKdl : public testing::TestWithParam<KdlRobot> {
 protected:
  const std::string text = contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/app/urdf" /
                                     (std::string(GetParam().name) + ".urdf"));
  const deflection::Arm arm = parseUrdf(text, GetParam().name).arm;

  void SetUp() override {
    const auto model = urdf::parseURDF(text);
    ASSERT_TRUE(model);
    KDL::Tree tree;
    ASSERT_TRUE(kdl_parser::treeFromUrdfModel(*model, tree));
    auto last = model->getRoot();
    for (; !last->child_links.empty(); last = last->child_links.front())
      if (const auto joint = last->child_joints.front(); joint->mimic) mimics_[joint->name] = *joint->mimic;
    ASSERT_TRUE(tree.getChain(model->getRoot()->name, last->name, chain_));
  }

  /// Returns the number of moving joints in KDL's chain.
  [[nodiscard]] unsigned kdlJoints() const { return chain_.getNrOfJoints(); }
  [[nodiscard]] std::size_t mimics() const { return mimics_.size(); }

  [[nodiscard]] KDL::Frame frameOf(const deflection::Arm& of, const Eigen::VectorXd& q) const {
    std::map<std::string, double> measurements;
    for (Eigen::Index k = 0; k < of.jointCount(); ++k) measurements[of.joint(k).name] = q[k];
    KDL::JntArray values(kdlJoints());
    unsigned at = 0;
    for (const auto& segment : chain_.segments) {
      const KDL::Joint& joint = segment.getJoint();
      if (joint.getType() == KDL::Joint::None) continue;
      const auto mimic = mimics_.find(joint.getName());
      values(at++) = mimic == mimics_.end()
                         ? measurements.at(joint.getName())
                         : mimic->second.multiplier * measurements.at(mimic->second.joint_name) + mimic->second.offset;
    }
    KDL::ChainFkSolverPos_recursive solver(chain_);
    KDL::Frame frame;
    EXPECT_GE(solver.JntToCart(values, frame), 0);
    return frame;
  }

  /// Expects the same tip positions and tool axes as from KDL over the whole joint range. The arm must be rigid,
  /// because KDL has no flexibility.
  void expectKdlsTips(const deflection::Arm& of) const {
    std::mt19937_64 random(4);
    for (int k = 0; k < kPostures; ++k) {
      Eigen::VectorXd q(of.jointCount());
      for (Eigen::Index j = 0; j < of.jointCount(); ++j)
        q[j] = std::uniform_real_distribution<double>(of.joint(j).lower, of.joint(j).upper)(random);
      const KDL::Frame frame = frameOf(of, q);
      const auto tip = deflection::solveFlexibleKinematics(of, {q}).X_BT;
      const Eigen::Vector3d place(frame.p.x(), frame.p.y(), frame.p.z());
      const Eigen::Vector3d axis(frame.M(0, 2), frame.M(1, 2), frame.M(2, 2));
      ASSERT_LE((tip.p - place).norm(), kSame) << q.transpose();
      ASSERT_LE((tip.R * of.tool_axis_L - axis).norm(), kSame) << q.transpose();
    }
  }

 private:
  KDL::Chain chain_;
  std::map<std::string, urdf::JointMimic> mimics_;
};

TEST_P(AgainstKdl, TheTipIsWhereKdlHasIt) {
  EXPECT_EQ(arm.jointCount(), GetParam().joints);
  EXPECT_EQ(kdlJoints(), static_cast<unsigned>(GetParam().joints) + mimics());
  expectKdlsTips(arm);
}

TEST_P(AgainstKdl, SoItIsOfTheArmWrittenAndReadAgain) {
  expectKdlsTips(parseUrdf(urdfOf(arm).text, "again.urdf").arm);
  const Units metres(parseYaml("units: {length: m, angle: deg, force: N}", "u.yaml").at("units"));
  expectKdlsTips(readArm(parseYaml(armYaml(arm, metres), "again.yaml")).arm);
}

INSTANTIATE_TEST_SUITE_P(Robots, AgainstKdl,
                         testing::Values(KdlRobot{"ur5", 6}, KdlRobot{"irb120", 6}, KdlRobot{"panda", 7},
                                         KdlRobot{"iiwa14", 7}, KdlRobot{"m10ia", 6}, KdlRobot{"palletizer", 4}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace tubeplan::app
