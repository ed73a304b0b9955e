// Calibration of a Universal Robots arm from its controller: calibration.conf, in the controller's folder .urcontrol.
//
// Section [mounting] has delta_theta, delta_a, delta_d and delta_alpha [rad, m], with one number for each joint from
// the base on. They are added to the standard Denavit-Hartenberg table of the model. The numbers of delta_d are huge
// and cancel for nearly parallel axes. Sources: maker's forum, "UR10 calibration.conf DH model generation";
// Universal_Robots_ROS_Driver, ur_calibration.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/formats/yaml/strict_yaml.hpp"

namespace tubeplan::app {

struct ControllerCalibration {
  std::vector<double> theta, a, d, alpha;  ///< corrections [rad, m], one for each joint in each
  std::vector<std::string> remarks;        ///< doubts about the numbers that the controller's status raises
};

/// Parses the text of calibration.conf; `path` names the file in messages. Throws InputError for a list that is
/// missing, is no list of numbers, or differs in length from the others.
[[nodiscard]] ControllerCalibration parseControllerCalibration(std::string_view text, const std::string& path);

/// Returns the text of the nominal arm's file with the numbers of the controller's calibration and everything else
/// unchanged. Throws InputError unless the arm has as many joints, all revolute, in rows by the standard convention.
[[nodiscard]] std::string withControllerCalibration(const YamlFile& nominal, const ControllerCalibration& calibration);

}  // namespace tubeplan::app
