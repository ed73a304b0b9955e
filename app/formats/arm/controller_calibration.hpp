// Calibration of a Universal Robots arm as stored by the robot's controller: file calibration.conf in the folder
// .urcontrol.
//
// Section [mounting] has the lists delta_theta, delta_a, delta_d and delta_alpha [rad, m], with one value for each
// joint from the base outwards. The values are added to the standard Denavit-Hartenberg table of the robot model. For
// nearly parallel axes the values of delta_d are huge and cancel each other. Sources: maker's forum, "UR10
// calibration.conf DH model generation"; Universal_Robots_ROS_Driver, ur_calibration.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/formats/yaml/strict_yaml.hpp"

namespace tubeplan::app {

struct ControllerCalibration {
  std::vector<double> theta, a, d, alpha;  ///< corrections [rad, m], each list with one value for each joint
  std::vector<std::string> remarks;        ///< warnings about a calibration whose status is not "in use"
};

/// Parses the text of calibration.conf; messages name the file as `path`. Throws InputError for a list that is missing,
/// contains anything but numbers, or differs in length from the other lists.
[[nodiscard]] ControllerCalibration parseControllerCalibration(std::string_view text, const std::string& path);

/// Returns the text of the nominal arm's file with the controller's corrections applied and everything else unchanged.
/// Throws InputError unless the arm has as many joints as the calibration, all revolute and in rows of the standard
/// convention.
[[nodiscard]] std::string withControllerCalibration(const YamlFile& nominal, const ControllerCalibration& calibration);

}  // namespace tubeplan::app
