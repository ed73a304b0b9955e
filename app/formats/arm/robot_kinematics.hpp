// Calibration of a Universal Robots arm as ROS stores it: a YAML file that ur_calibration writes from the controller's
// numbers, and that ur_description reads as kinematics_config (Universal_Robots_ROS2_Driver).
//
// `kinematics` has one origin {x, y, z, roll, pitch, yaw} [m, rad] for each of six joints, as in the joint's URDF, and
// the hash of the controller's numbers. All origins are near those of the drawing: unlike the controller's numbers,
// they contain no lengths that cancel.
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

/// Reads the map of such a file. Throws InputError for a joint or a number that is missing or unknown.
[[nodiscard]] RobotKinematics readRobotKinematics(const YamlNode& root);

/// Returns the text of the nominal arm's file with these origins in its rows with joints and everything else unchanged.
/// A first row rotated by half a turn about the base's z, as in the robot's URDF, keeps that rotation. Throws
/// InputError unless the arm has six rows with joints, by origin, revolute and without offsets. Also refuses an origin
/// that would move by more than 50 mm or 10 deg, which indicates another model.
[[nodiscard]] std::string withRobotKinematics(const YamlFile& nominal, const RobotKinematics& kinematics);

/// Returns the text of such a file, with every number exact to the last bit.
[[nodiscard]] std::string robotKinematicsText(const RobotKinematics& kinematics);

/// Returns the origins of an arm's joints, each combined with the offset, the lean and the passive rows before it; a
/// base rotated by half a turn about z is rotated back. `file` names the arm's file in messages. Throws InputError
/// unless the arm has six rows with joints, revolute and by origin.
[[nodiscard]] RobotKinematics robotKinematicsOf(const deflection::Arm& arm, const std::string& file);

}  // namespace tubeplan::app
