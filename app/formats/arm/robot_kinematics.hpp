// Calibration of a Universal Robots arm in the YAML format of ROS: ur_calibration writes the file from the controller's
// numbers, and ur_description reads the file as kinematics_config (Universal_Robots_ROS2_Driver).
//
// `kinematics` has one origin {x, y, z, roll, pitch, yaw} [m, rad] for each of six joints, as in the robot's URDF, and
// a hash of the controller's numbers. All origins are close to their nominal values, unlike the controller's numbers,
// which contain large lengths that cancel.
#pragma once

#include <array>
#include <string>

#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

struct RobotKinematics {
  std::array<deflection::Origin<double>, 6> origins;  ///< origins of the joints [m, rad], from the base outwards
  std::string hash;                                   ///< hash of the controller's numbers; empty if the file has none
};

/// Reads the root map of a kinematics file. Throws InputError for a joint or number that is missing or unknown.
[[nodiscard]] RobotKinematics readRobotKinematics(const YamlNode& root);

/// Returns the text of the nominal arm's file in which the rows with joints have the origins of `kinematics`, and
/// everything else is unchanged. A first row rotated by half a turn about the base's z, as in the robot's URDF, keeps
/// that rotation. Throws InputError unless the arm has six rows with joints, all revolute, with origins and without
/// offsets. Also throws InputError if an origin would move by more than 50 mm or 10 deg, which indicates another robot
/// model.
[[nodiscard]] std::string withRobotKinematics(const YamlFile& nominal, const RobotKinematics& kinematics);

/// Returns the text of a kinematics file, with numbers at full precision.
[[nodiscard]] std::string robotKinematicsText(const RobotKinematics& kinematics);

/// Returns the origins of an arm's joints, each combined with the joint's offset, the row's tilt beta and the passive
/// rows before it. A base rotated by half a turn about z is rotated back. Messages name the arm's file as `file`.
/// Throws InputError unless the arm has six rows with joints, all revolute and with origins.
[[nodiscard]] RobotKinematics robotKinematicsOf(const deflection::Arm& arm, const std::string& file);

}  // namespace tubeplan::app
