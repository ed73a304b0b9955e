// What a Universal Robots controller knows of its own arm: calibration.conf, in the controller's folder .urcontrol.
//
// Section [mounting] has delta_theta, delta_a, delta_d and delta_alpha, one number for each joint from the base on
// [rad, m]: what is to be added to the standard Denavit-Hartenberg table of the model (maker's forum, "UR10
// calibration.conf DH model generation"; Universal_Robots_ROS_Driver, ur_calibration). Those of d are huge and cancel
// where axes are nearly parallel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/formats/yaml/strict_yaml.hpp"

namespace tubeplan::app {

struct ControllerCalibration {
  std::vector<double> theta, a, d, alpha;  ///< rad, m; as many of each, one for each joint
  std::vector<std::string> remarks;        ///< what the controller says against it
};

/// Throws InputError for a list that is missing, no list of numbers, or not as long as the others; `path` names the
/// file in messages.
[[nodiscard]] ControllerCalibration parseControllerCalibration(std::string_view text, const std::string& path);

/// The text of the nominal arm's file with the numbers of the controller's calibration, all else as it stands. Throws
/// InputError for an arm whose rows with joints are not as many, revolute, and by the standard convention.
[[nodiscard]] std::string withControllerCalibration(const YamlFile& nominal, const ControllerCalibration& calibration);

}  // namespace tubeplan::app
