#include "app/formats/foreign/joint_patterns.hpp"

#include <fmt/format.h>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/column_names.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using JointNames = std::vector<std::string>;

/// Returns an arm with these joint names, in order.
deflection::Arm armWith(const JointNames& names) {
  auto arm = readCell((shippedCells() / "bench.yaml").string()).arm;
  std::size_t k = 0;
  for (auto& row : arm.rows)
    if (row.joint.type != deflection::JointType::kPassive) row.joint.name = names.at(k++);
  return arm;
}

ForeignMeasurements readColumns(const JointNames& joints, const std::string& columns, const std::string& row) {
  return readForeign({{parseForeignTable(columns + ",x_mm,y_mm,z_mm\n" + row + ",1,2,3\n", "t")},
                      {{}, {{UnitKind::kAngle, findUnit(UnitKind::kAngle, "deg")}}},
                      ""},
                     armWith(joints));
}

const JointNames kNumbered{"theta1", "theta2", "theta3", "theta4"};
const JointNames kCalled{"shoulder_pan", "shoulder_lift", "elbow", "wrist_1"};
const JointNames kWithArm{"left_shoulder_pan_joint", "left_shoulder_lift_joint", "left_elbow_joint",
                          "left_wrist_1_joint"};

TEST(JointPatterns, TakeJointsBetweenTheSameWords) {
  const struct {
    const JointNames& joints;
    const char* columns;
  } cases[] = {
      {kNumbered, "panda_joint1,panda_joint2,panda_joint3,panda_joint4"},
      {kNumbered, "joint_1_position,joint_2_position,joint_3_position,joint_4_position"},
      {kNumbered,
       "/joint_states/position[0],/joint_states/position[1],/joint_states/position[2],/joint_states/position[3]"},
      {kNumbered, "left_arm/J1 [deg],left_arm/J2 [deg],left_arm/J3 [deg],left_arm/J4 [deg]"},
      {kNumbered, "J1Position,J2Position,J3Position,J4Position"},
      {kCalled,
       "right_arm_shoulder_pan_joint [deg],right_arm_shoulder_lift_joint [deg],right_arm_elbow_joint [deg],"
       "right_arm_wrist_1_joint [deg]"},
      {kWithArm, "shoulder_pan,shoulder_lift,elbow,wrist_1"},
      {kNumbered,
       "position[0],position[1],position[2],position[3],velocity[0],velocity[1],velocity[2],velocity[3],"
       "effort[0],effort[1],effort[2],effort[3]"},
  };
  for (const auto& c : cases) {
    const auto fields = 1 + std::count(c.columns, c.columns + std::string(c.columns).size(), ',');
    std::string row = "10,45,-35,12";
    for (long k = 4; k < fields; ++k) row += ",9";
    const auto measurements = readColumns(c.joints, c.columns, row);
    EXPECT_NE(measurements.text.find(
                  fmt::format("{}_deg,{}_deg,{}_deg,{}_deg,x_mm", c.joints[0], c.joints[1], c.joints[2], c.joints[3])),
              std::string::npos)
        << c.columns << "\n"
        << measurements.text;
    EXPECT_NE(measurements.text.find(",10,45,-35,12,1,2,3"), std::string::npos) << measurements.text;
  }
}

// Columns in any order must be assigned to the joints by their numbers.
TEST(JointPatterns, TakeJointsInAnyOrder) {
  const auto measurements = readColumns(kNumbered, "arm_J3,arm_J1,arm_J4,arm_J2", "-35,10,12,45");
  EXPECT_NE(measurements.text.find(",10,45,-35,12,1,2,3"), std::string::npos) << measurements.text;
}

TEST(JointPatterns, RefuseTwoSetsWithBothNamed) {
  const std::string message = messageOf([] {
    (void)readColumns(kNumbered, "desired_J1,desired_J2,desired_J3,desired_J4,actual_J1,actual_J2,actual_J3,actual_J4",
                      "10,45,-35,12,11,46,-34,13");
  });
  expectSays(message, "desired_J1");
  expectSays(message, "actual_J4");
  expectSays(message, "--column 'theta4=");
}

TEST(JointPatterns, RefuseColumnsOfNoJoints) {
  for (const char* columns :
       {"temp_1,temp_2,temp_3,temp_4", "velocity[0],velocity[1],velocity[2],velocity[3]", "data1,data2,data3,data4",
        "arm_J1,arm_J2,arm_J3,leg_J4", "arm_J1,arm_J2,arm_J3,arm_J5", "J1_torque,J2_torque,J3_torque,J4_torque"})
    expectSays(messageOf([&] { (void)readColumns(kNumbered, columns, "10,45,-35,12"); }),
               "none is recognised as the joint theta1");
}

}  // namespace
}  // namespace tubeplan::app
