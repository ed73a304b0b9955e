// Reader of arms in URDF, the robot description format of ROS.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Solid of a link in its row's frame, in the syntax of a cell's link_shapes.
struct UrdfShape {
  std::string row;
  std::string text;  ///< text of the shape: "capsule: {from: [...], to: [...], radius: 0.1}" [m, deg]
};

/// Joint between the root and the tip. P is its parent link, C its child link, L the frame of its row.
struct UrdfJoint {
  std::string name;
  Eigen::Isometry3d X_PC;  ///< origin of the joint: its pose at zero reading
  Eigen::Isometry3d X_CL;  ///< rotation of z to the axis; identity for a joint without a row
  Eigen::Vector3d rpy;     ///< rpy of the origin, as written [rad]
};

struct UrdfArm {
  deflection::Arm arm;            ///< rigid arm: URDF states no stiffness
  std::string tip;                ///< name of the link at the end of the chain
  std::vector<UrdfJoint> joints;  ///< joints from the root to the tip: those with rows, then fixed ones of the tool
  std::vector<UrdfShape> shapes;
  std::vector<std::string> left_out;  ///< content of the file that an arm does not have, a sentence each
  std::vector<std::string> remarks;   ///< remarks on values that are accepted but may be mistakes
};

/// Returns the chain from the root of a robot to its link `tip`; if empty, to the only leaf at the end of the longest
/// chain. Every joint of the chain is a row, with the name of its child link and its pose in the file, rotated so that
/// the joint's axis is its z. Fixed joints after the last moving one are the tool, whose frame is that of the tip link.
/// Masses, also of parts fixed to the chain, become lumps (m g, at the centre of mass). Joints with `mimic` follow
/// others, also through further ones. Throws InputError for text that is no URDF, for a missing link and for an
/// unsupported arm (floating and planar joints).
[[nodiscard]] UrdfArm parseUrdf(const std::string& text, const std::string& file, const std::string& tip = "");

}  // namespace tubeplan::app
