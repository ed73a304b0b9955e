// Arms out of URDF, the format that ROS describes robots in.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

/// A solid of a link in its row's frame, as a cell writes it (link_shapes).
struct UrdfShape {
  std::string row;
  std::string text;  ///< "capsule: {from: [...], to: [...], radius: 0.1}", in m and deg
};

/// A joint on the way to the tip. P is its parent link, C its child link, L the frame of the row that it is.
struct UrdfJoint {
  std::string name;
  Eigen::Isometry3d X_PC;  ///< at zero reading: the joint's origin
  Eigen::Isometry3d X_CL;  ///< turns the axis to z; identity where the joint is no row
  Eigen::Vector3d rpy;     ///< of the origin, as written [rad]
};

struct UrdfArm {
  deflection::Arm arm;            ///< rigid: URDF states no stiffness
  std::string tip;                ///< the link at the end of the chain
  std::vector<UrdfJoint> joints;  ///< from the root to the tip: a row each, then fixed ones that carry the tool
  std::vector<UrdfShape> shapes;
  std::vector<std::string> left_out;  ///< what the file says and an arm does not take, a sentence each
  std::vector<std::string> remarks;   ///< on what is taken as it is written and may be meant otherwise
};

/// The chain from the root of a robot to its link `tip`; empty: to the only leaf that the longest chain ends at. Every
/// joint on the way is a row, named as the link that it carries and placed as the file has it, turned so that the
/// joint's axis is its z; fixed joints behind the last moving one are the tool, whose frame is the tip link's. Masses
/// become lumps (m g, at the centre of mass), those of what is fixed beside the chain too; joints with `mimic` follow,
/// also through others that do. Throws InputError for what is no URDF, for a link that is not there, for an arm that
/// the program cannot take (floating and planar joints).
[[nodiscard]] UrdfArm parseUrdf(const std::string& text, const std::string& file, const std::string& tip = "");

}  // namespace tubeplan::app
