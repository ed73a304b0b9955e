// What ROS keeps of a Universal Robots arm's calibration: the YAML file that ur_calibration writes from the
// controller's numbers, and ur_description reads as kinematics_config (Universal_Robots_ROS2_Driver).
//
// `kinematics` has one origin {x, y, z, roll, pitch, yaw} [m, rad] for each of six joints, that of the joint in its
// URDF, and the hash of the controller's numbers. No origin is far off the drawing's: unlike the controller's, they
// hold no lengths that cancel.
#pragma once

#include <array>
#include <string>

#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

struct RobotKinematics {
  std::array<deflection::Origin<double>, 6> origins;  ///< m, rad; from the base outwards
  std::string hash;                                   ///< empty where the file has none
};

/// Throws InputError for a joint or a number that is missing or unknown.
[[nodiscard]] RobotKinematics readRobotKinematics(const YamlNode& root);

/// Returns the text of the nominal arm's file with these origins in its rows with joints, all else as it stands; a
/// first row that stands half a turn about the base's z, as that of the robot's URDF, keeps it. Throws InputError for
/// an arm whose rows with joints are not six by origin, revolute and without offsets, or that one of the origins would
/// move by more than 50 mm or 10 deg: those are of another model.
[[nodiscard]] std::string withRobotKinematics(const YamlFile& nominal, const RobotKinematics& kinematics);

/// Returns the file's text of the same numbers to the last bit.
[[nodiscard]] std::string robotKinematicsText(const RobotKinematics& kinematics);

/// Returns what such a file has of an arm: of each joint its origin, with the offset, the lean and passive rows before
/// it; a base half a turn about z is turned back. `file` is the arm's, for messages. Throws InputError for an arm whose
/// rows with joints are not six, revolute and by origin.
[[nodiscard]] RobotKinematics robotKinematicsOf(const deflection::Arm& arm, const std::string& file);

}  // namespace tubeplan::app
