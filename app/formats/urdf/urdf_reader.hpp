// Reader of arms in URDF, the robot description format of ROS.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Solid of a link relative to the frame of the link's row, in the syntax of link_shapes in a cell.
struct UrdfShape {
  std::string row;
  std::string text;  ///< shape as YAML text, such as "capsule: {from: [...], to: [...], radius: 0.1}" [m, deg]
};

/// Joint between the root and the tip. Frames: P of the parent link, C of the child link, L of the joint's row.
struct UrdfJoint {
  std::string name;
  Eigen::Isometry3d X_PC;  ///< origin of the joint: pose of C relative to P at zero reading
  Eigen::Isometry3d X_CL;  ///< rotation of the z axis to the joint's axis; identity for a joint without a row
  Eigen::Vector3d rpy;     ///< roll, pitch and yaw of the origin as written in the file [rad]
};

struct UrdfArm {
  deflection::Arm arm;            ///< arm with rigid links and joints, because URDF states no stiffness
  std::string tip;                ///< name of the link at the end of the chain
  std::vector<UrdfJoint> joints;  ///< joints from the root to the tip: joints with rows, then fixed joints of the tool
  std::vector<UrdfShape> shapes;
  std::vector<std::string> left_out;  ///< parts of the file that an arm cannot represent, one sentence each
  std::vector<std::string> remarks;   ///< remarks on values that are accepted but may be mistakes, one sentence each
};

/// Returns the chain from a robot's root to the link `tip`; if `tip` is empty, to the only leaf at the end of the
/// longest chain. Every joint of the chain becomes a row, with the name of the joint's child link. The row has the
/// joint's pose from the file, rotated so that the joint's axis is the row's z. Fixed joints after the last moving
/// joint form the tool, whose frame is the tip link's. Masses, including those of parts fixed to the chain, become
/// lumps (m g, at the centre of mass). Joints with `mimic` follow other joints, even through intermediate `mimic`
/// joints. Throws InputError for text that is not URDF and for an unsupported arm (floating or planar joints), and
/// InputQuestion, which offers the possible tips, where another tip may avoid the error.
[[nodiscard]] UrdfArm parseUrdf(const std::string& text, const std::string& file, const std::string& tip = "");

}  // namespace tubeplan::app
